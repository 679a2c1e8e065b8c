// Texts and bytes, compressed and written in letters that addresses and pages may hold.
const through = (blob, stream) => new Response(blob.stream().pipeThrough(stream));

/** @returns the text, compressed, in letters, digits, - and _ */
export async function pack(text) {
  const bytes = new Uint8Array(await through(new Blob([text]), new CompressionStream('deflate')).arrayBuffer());
  let binary = '';
  bytes.forEach(byte => { binary += String.fromCharCode(byte); });
  return btoa(binary).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

/** The text of what pack has made, or of any zlib stream in base64. */
export async function unpack(packed) {
  const binary = atob(packed.trim().replace(/-/g, '+').replace(/_/g, '/'));
  return through(new Blob([Uint8Array.from(binary, letter => letter.charCodeAt(0))]),
      new DecompressionStream('deflate')).text();
}

/** Hands a file to the person at the browser. */
export function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);      // some browsers read it after the click
}
