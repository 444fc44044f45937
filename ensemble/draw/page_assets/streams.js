'use strict';
// Reads the compressed streams that the program put into a page (ensemble/draw/page_parts.hpp).

function takenBytes(id) {
  const element = document.getElementById(id);
  const text = atob(element.textContent);
  element.remove(); // its memory is needed elsewhere
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(id) {
  const plain = new Blob([takenBytes(id)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(plain).arrayBuffer();
}
