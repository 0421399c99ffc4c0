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
      var title = wordsOf(section[3]), text = wordsOf(section[4]), page = wordsOf(section[1] + " " + section[0]);
      for (var i = 0; i < words.length; ++i) {
        var inTitle = countOf(words[i], title, 2), inText = countOf(words[i], text, 5);
        hasAll = hasAll && inTitle + inText > 0;
        score += 12 * inTitle + inText + 5 * countOf(words[i], page, 2);
      }
      if (hasAll) hits.push({row: row, score: score, page: section[0], anchor: section[2], title: section[3],
                             pageTitle: section[1], excerpt: excerptOf(section[4], words)});
    }
    hits.sort(function (a, b) { return b.score - a.score || a.row - b.row; });
    return hits.slice(0, 60);
  }

  return {find: find};
})();

if (typeof document !== "undefined") {
  (function () {
    var field = document.getElementById("search"), list = document.getElementById("hits");
    var contents = document.getElementById("contents");
    field.hidden = false;
    field.addEventListener("input", function () {
      var hits = guideSearch.find(guideIndex, field.value);
      list.textContent = "";
      list.hidden = field.value.trim() === "";
      contents.hidden = !list.hidden;
      for (var i = 0; i < hits.length; ++i) {
        var item = document.createElement("li"), link = document.createElement("a");
        link.href = hits[i].page + ".html" + (hits[i].anchor ? "#" + hits[i].anchor : "");
        link.textContent = hits[i].title || hits[i].pageTitle;
        var where = document.createElement("small");
        where.textContent = hits[i].pageTitle + (hits[i].excerpt ? ": " + hits[i].excerpt : "");
        item.appendChild(link);
        item.appendChild(where);
        list.appendChild(item);
      }
      if (hits.length === 0 && !list.hidden) list.textContent = "Nothing was found.";
    });
  })();
}
