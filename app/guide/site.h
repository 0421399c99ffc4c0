#pragma once
#include <string>

#include "app/guide/guide.h"

namespace underact::guide {

/// The guide as pages for a browser: HTML, a style sheet, a search, and the pictures that the pages show; no network is
/// needed. out: a folder, created if it is missing. Problems: what could not be written, formulas that cannot be read,
/// pictures that are missing.
Problems writeSite(const Guide& guide, const std::string& out);

/// A page's HTML in its frame: the search, the contents with this page marked, and the pages before and after it.
std::string sitePage(const Guide& guide, const Entry& entry);

/// What a link of a page is among the static pages: a page of Markdown becomes its HTML, a scene its place in the list
/// of scenes, a lesson the page of lessons, and what only the window can do the page of the window.
std::string siteLink(const std::string& link);

/// The picture for a dark screen that lies beside one of a page: NAME_dark beside NAME_light or NAME; empty where there
/// is none.
std::string darkPicture(const Guide& guide, const std::string& picture);

}  // namespace underact::guide
