// Searches the guide's pages as the window does: sections that have each word, or one that begins with it, the best
// first. Plain and old JavaScript, so that every browser runs it from a file.
var guideSearch = (function () {
  function wordsOf(text) {
    return text.toLowerCase().match(/[0-9a-z_\u0080-\uffff]+/g) || [];
  }

  // Each word that begins with `word` counts once, a whole one twice.
  function countOf(word, words, most) {
    var count = 0;
    for (var i = 0; i < words.length && count < most; ++i)
      if (words[i].indexOf(word) === 0) count += words[i].length === word.length ? 2 : 1;
    return Math.min(count, most);
  }

  function excerptOf(text, words) {
    var lower = text.toLowerCase(), at = 0, size = 60;  // found by its title alone: how it begins
    for (var i = 0; i < words.length; ++i) {
      var place = (" " + lower).search(new RegExp("[^0-9a-z_\u0080-\uffff]" + words[i]));
      if (place < 0) continue;
      at = place;
      size = words[i].length;
      break;
    }
    var from = Math.max(0, at - 60), end = Math.min(text.length, at + size + 60);
    return (from > 0 ? "…" : "") + text.substring(from, end) + (end < text.length ? "…" : "");
  }

  // index: rows of [page, its title, anchor, the section's title, its text].
  function find(index, typed) {
    var words = wordsOf(typed), hits = [];
    for (var row = 0; words.length > 0 && row < index.length; ++row) {
      var section = index[row], score = 0, hasAll = true;
      // Read once: what follows the first letter is to be there at once.
      var known = section.words = section.words || {title: wordsOf(section[3]), text: wordsOf(section[4]),
                                                    page: wordsOf(section[1] + " " + section[0])};
      for (var i = 0; i < words.length; ++i) {
        var inTitle = countOf(words[i], known.title, 2), inText = countOf(words[i], known.text, 5);
        hasAll = hasAll && inTitle + inText > 0;
        score += 12 * inTitle + inText + 5 * countOf(words[i], known.page, 2);
      }
      if (hasAll) hits.push({row: row, score: score, page: section[0], anchor: section[2], title: section[3],
                             pageTitle: section[1], excerpt: excerptOf(section[4], words)});
    }
    hits.sort(function (a, b) { return b.score - a.score || a.row - b.row; });
    return hits.slice(0, 60);
  }

  // What is said of them, to those who do not see the list, too.
  function said(count, typed) {
    if (count === 0) return "Nothing was found for “" + typed + "”.";
    if (count === 60) return "The best 60 sections.";
    return count === 1 ? "1 section." : count + " sections.";
  }

  return {find: find, said: said};
})();

if (typeof document !== "undefined") {
  (function () {
    function part(name) { return document.getElementById(name); }
    var field = part("search"), found = part("found"), list = part("hits"), contents = part("contents");

    function itemOf(hit) {
      var item = document.createElement("li"), link = document.createElement("a");
      link.href = hit.page + ".html" + (hit.anchor ? "#" + hit.anchor : "");
      link.textContent = hit.title || hit.pageTitle;
      var where = document.createElement("small");
      where.textContent = hit.pageTitle + (hit.excerpt ? ": " + hit.excerpt : "");
      item.appendChild(link);
      item.appendChild(where);
      return item;
    }

    function show() {
      var typed = field.value.trim(), hits = guideSearch.find(guideIndex, typed);
      list.textContent = "";
      for (var i = 0; i < hits.length; ++i) list.appendChild(itemOf(hits[i]));
      list.hidden = hits.length === 0;
      contents.hidden = typed !== "";
      found.textContent = typed === "" ? "" : guideSearch.said(hits.length, typed);
    }

    // The arrows go from the field through what was found, and back.
    function step(by) {
      var links = Array.prototype.slice.call(list.getElementsByTagName("a"));
      var next = links.indexOf(document.activeElement) + by;
      if (next < 0) field.focus();
      else if (next < links.length) links[next].focus();
    }

    function clear() {
      field.value = "";
      show();
      field.focus();
    }

    function inSearch(event) {
      if (event.key === "ArrowDown") step(1);
      else if (event.key === "ArrowUp") step(-1);
      else if (event.key === "Escape") clear();
      else if (event.key === "Enter" && event.target === field && list.firstChild) list.getElementsByTagName("a")[0].click();
      else return;
      event.preventDefault();
    }

    part("find").hidden = false;
    part("find").addEventListener("keydown", inSearch);
    field.addEventListener("input", show);
    window.addEventListener("pageshow", show);  // after going back a browser may have kept what was typed
    document.addEventListener("keydown", function (event) {
      if (event.key !== "/" || event.ctrlKey || event.altKey || event.metaKey || event.target === field) return;
      event.preventDefault();
      field.focus();
      field.select();
    });

    // Above the page of a narrow window the contents are folded up; beside it they show this page's line.
    var narrow = window.matchMedia("(max-width: 900px)");
    function fold() { contents.open = !narrow.matches; }
    fold();
    if (narrow.addEventListener) narrow.addEventListener("change", fold);
    var guide = document.querySelector("nav.guide"), here = guide.querySelector("li.here");
    if (here && !narrow.matches) guide.scrollTop = here.offsetTop - guide.clientHeight / 2;
  })();
}
