// What tests/guide/in_browser asks of a page that is shown: functions without a memory, each for plain values.
var checks = (function () {
  function shown(element) {
    var box = element.getBoundingClientRect();
    return box.width > 1 && box.height > 1 && getComputedStyle(element).visibility === "visible";
  }

  function named(element) {
    var text = (element.textContent || element.getAttribute("alt") || "").trim().replace(/\s+/g, " ");
    return element.tagName.toLowerCase() + (element.className ? "." + element.className : "") + " \"" + text.slice(0, 50) + "\"";
  }

  function scrolls(element) {
    for (var up = element.parentElement; up; up = up.parentElement)
      if (up !== document.documentElement && up !== document.body && /auto|scroll/.test(getComputedStyle(up).overflowX)) return true;
    return false;
  }

  // What reaches beyond the window without lying in a part that scrolls by itself. On paper nothing scrolls.
  function tooWide(onPaper) {
    var found = [], width = document.documentElement.clientWidth;
    if (document.documentElement.scrollWidth > width) found.push("the page is " + document.documentElement.scrollWidth + " px wide");
    document.querySelectorAll("body *").forEach(function (element) {
      if (!shown(element)) return;
      var box = element.getBoundingClientRect();
      if (box.right > width + 1 && (onPaper || !scrolls(element))) found.push(named(element) + " ends at " + Math.round(box.right) + " px");
      if (box.left < -1 && (onPaper || !scrolls(element))) found.push(named(element) + " begins at " + Math.round(box.left) + " px");
      if (onPaper && element.scrollWidth > element.clientWidth + 1 && /auto|scroll|hidden/.test(getComputedStyle(element).overflowX))
        found.push(named(element) + " is cut");
    });
    return found.slice(0, 5);
  }

  // [red, green, blue, alpha] of a colour as a computed style has it.
  function colour(text) {
    var numbers = text.match(/[\d.]+/g).map(Number);
    return numbers.length > 3 ? numbers : numbers.concat(1);
  }
  function over(top, below) {
    return [0, 1, 2].map(function (i) { return top[i] * top[3] + below[i] * (1 - top[3]); }).concat(1);
  }
  function ground(element) {
    var layers = [];
    for (var up = element; up; up = up.parentElement) layers.push(colour(getComputedStyle(up).backgroundColor));
    var canvas = matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18, 1] : [255, 255, 255, 1];
    return layers.reverse().reduce(function (below, top) { return over(top, below); }, canvas);
  }
  // Relative luminance and contrast: WCAG 2.1, success criterion 1.4.3.
  function luminance(rgb) {
    var part = rgb.slice(0, 3).map(function (value) {
      value /= 255;
      return value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    });
    return 0.2126 * part[0] + 0.7152 * part[1] + 0.0722 * part[2];
  }
  function contrast(ink, paper) {
    var one = luminance(over(ink, paper)), other = luminance(paper);
    return (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
  }

  function tooFaint() {
    var found = {};
    function look(style, element) {
      var ink = colour(style.color), size = parseFloat(style.fontSize);
      ink[3] *= Number(style.opacity);
      var ratio = contrast(ink, ground(element));
      var needed = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
      if (ratio < needed) found[named(element) + ": contrast " + ratio.toFixed(2) + " of " + needed] = true;
    }
    var texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), text;
    while ((text = texts.nextNode()))
      if (text.nodeValue.trim() && shown(text.parentElement)) look(getComputedStyle(text.parentElement), text.parentElement);
    document.querySelectorAll("input[placeholder]").forEach(function (field) { look(getComputedStyle(field, "::placeholder"), field); });
    return Object.keys(found).slice(0, 5);
  }

  // Paper has no contents, and dark letters on white.
  function onPaper() {
    var found = [];
    document.querySelectorAll("nav, a.skip").forEach(function (part) { if (shown(part)) found.push(named(part) + " is printed"); });
    var ink = colour(getComputedStyle(document.body).color), paper = ground(document.body);
    if (luminance(paper) < 0.9 || contrast(ink, paper) < 7) found.push("letters of " + ink + " on " + paper);
    return found;
  }

  function facts() {
    function all(selector, get) { return Array.prototype.map.call(document.querySelectorAll(selector), get); }
    var wrong = [];
    all("img", function (image) {
      if (image.naturalWidth === 0) wrong.push(image.src + " is no picture");
      if (!image.alt.trim()) wrong.push(image.src + " is not described");
    });
    if (!document.documentElement.lang || !document.title) wrong.push("has no title, or no language");
    if (document.querySelectorAll("h1").length !== 1) wrong.push("has not one heading above all");
    return {
      links: all("a[href]", function (link) { return link.href; }),
      anchors: all("[id]", function (element) { return element.id; }),
      wrong: wrong
    };
  }

  return {tooWide: tooWide, tooFaint: tooFaint, onPaper: onPaper, facts: facts};
})();
