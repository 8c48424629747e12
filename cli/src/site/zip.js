// Archives in the format ZIP, stored without compression: names in UTF-8, no dates.
//
// A library for archives has some 10 kB compressed and a licence of its own; files of code are small.

// The check sum of bytes: CRC-32 of ISO 3309.
const CRC = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit += 1) rest = rest & 1 ? 0xedb88320 ^ (rest >>> 1) : rest >>> 1;
  return rest;
});
const checkSum = (bytes) => ~bytes.reduce((sum, byte) => CRC[(sum ^ byte) & 255] ^ (sum >>> 8), ~0) >>> 0;

// Numbers as little-endian bytes, each with its size.
const packedNumbers = (...pairs) => Uint8Array.from(pairs.flatMap(([value, size]) => Array.from({ length: size }, (_, k) => (value >>> (8 * k)) & 255)));

// An archive of files with names and texts, in a folder.
function zipped(folder, files) {
  const encode = (text) => new TextEncoder().encode(text);
  const parts = [];
  const directory = [];
  let offset = 0;
  for (const { name, text } of files) {
    const [path, bytes] = [encode(`${folder}/${name}`), encode(text)];
    // Version 2.0, names in UTF-8, stored, 1 January 1980.
    const shared = [[20, 2], [0x0800, 2], [0, 2], [0, 2], [0x21, 2], [checkSum(bytes), 4], [bytes.length, 4], [bytes.length, 4], [path.length, 2], [0, 2]];
    const local = packedNumbers([0x04034b50, 4], ...shared);
    parts.push(local, path, bytes);
    directory.push(packedNumbers([0x02014b50, 4], [20, 2], ...shared, [0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]), path);
    offset += local.length + path.length + bytes.length;
  }
  const size = directory.reduce((sum, part) => sum + part.length, 0);
  const end = packedNumbers([0x06054b50, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [size, 4], [offset, 4], [0, 2]);
  return new Blob([...parts, ...directory, end], { type: "application/zip" });
}
