// What the page of the search adds to Sphinx's: its results in a better order, each with its words in their place.
"use strict";

const wordsOfQuery = () =>
  (new URLSearchParams(location.search).get("q") || "").toLowerCase().split(/[^\p{L}\p{N}_]+/u).filter(Boolean);

// The paragraphs of a page in which most of the words stand, and how many of the words those are.
const bestParagraphs = (page) => {
  const words = wordsOfQuery();
  const counted = siteTexts[page].split("\n\n").map((text) => {
    const lower = text.toLowerCase();
    return [text, words.filter((word) => lower.includes(word)).length];
  });
  const most = Math.max(...counted.map(([, count]) => count));
  return { most, texts: counted.filter(([, count]) => count === most).map(([text]) => text) };
};

// Sphinx takes all pages that have the words as equal. The more of their paragraphs have all of them, the higher; the
// history of changes comes last.
Scorer.score = ([page, , anchor, , score]) => {
  if (anchor || !(page in siteTexts)) return score;
  const { most, texts } = bestParagraphs(page);
  const together = most === wordsOfQuery().length ? 2 * Math.log2(1 + texts.length) : 0;
  return score + together - (page === "CHANGELOG" ? 20 : 0);
};

// Sphinx would fetch each page that it found, to show where the words stand. Browsers refuse that on a disk; the texts of
// all pages are in texts.js instead.
const fetched = window.fetch;
window.fetch = (address, ...rest) => {
  const page = String(address).replace(/^\.\//, "").replace(/\.html$/, "");
  if (!(page in siteTexts)) return fetched(address, ...rest);
  const main = document.createElement("div");
  main.setAttribute("role", "main");
  main.textContent = bestParagraphs(page).texts[0];
  return Promise.resolve({ text: () => Promise.resolve(main.outerHTML) });
};
