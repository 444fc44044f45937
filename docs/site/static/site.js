// What every page adds to Sphinx and Furo.
"use strict";

// Whoever comes from the search sees the words at once: the first block that has most of them.
addEventListener("load", () => setTimeout(() => {
  const blocks = [...document.querySelectorAll("article :is(h1, h2, h3, h4, p, li, tr, pre):has(.highlighted)")];
  if (location.hash || !blocks.length || document.getElementById("search-results")) return;
  const counts = blocks.map((block) =>
    new Set([...block.querySelectorAll(".highlighted")].map((word) => word.textContent.toLowerCase())).size);
  blocks[counts.indexOf(Math.max(...counts))].scrollIntoView({ block: "center" });
}, 100));

// Called by versions.js, which lists the releases that are built side by side: version -> its pages.
const showVersions = (versions) => {
  const place = document.getElementById("versions");
  for (const [version, pages] of Object.entries(versions)) {
    const here = version === place.dataset.version;
    const link = place.appendChild(document.createElement(here ? "strong" : "a"));
    link.textContent = version;
    const page = pages.includes(place.dataset.page) ? place.dataset.page : "index.html";
    if (!here) link.href = `${place.dataset.folder}/${version}/${page}`;
  }
};
