// Duration of a recorded WebM film. Browsers record without it, so players show no length and cannot go to a time.

const INFO = [0x15, 0x49, 0xa9, 0x66]; // identifier of the element that holds the duration
const DURATION = [0x44, 0x89, 0x88]; // identifier of the duration, and its size of eight bytes
const HEAD = 4096; // largest distance of the element from the start of a film [bytes]

function indexOf(bytes: Uint8Array, sought: readonly number[], from: number, to: number): number {
  for (let i = from; i + sought.length <= to; ++i) if (sought.every((byte, k) => bytes[i + k] === byte)) return i;
  return -1;
}

/** Returns the size that an element states, and the length of the statement [bytes]; null if the size is not stated. */
function sizeAt(bytes: Uint8Array, at: number): {size: number; length: number} | null {
  const length = Math.clz32(bytes[at]) - 23;
  if (!(length >= 1 && length <= 8) || at + length > bytes.length) return null;
  let size = bytes[at] & (0xff >> length);
  for (let k = 1; k < length; ++k) size = 256 * size + bytes[at + k];
  return size < bytes.length ? {size, length} : null;
}

/** Returns a WebM film with its duration [ms]; the same film if it states one or is of another format. */
export function withDuration(film: Uint8Array<ArrayBuffer>, duration: number): Uint8Array<ArrayBuffer> {
  const info = indexOf(film, INFO, 0, Math.min(HEAD, film.length));
  const stated = info < 0 ? null : sizeAt(film, info + INFO.length);
  if (!stated) return film;
  const begin = info + INFO.length + stated.length,
    end = begin + stated.size;
  if (end > film.length || indexOf(film, DURATION.slice(0, 2), begin, end) >= 0) return film;
  const added = new DataView(new ArrayBuffer(8 + DURATION.length + 8));
  added.setBigUint64(0, (1n << 56n) | BigInt(stated.size + DURATION.length + 8));
  DURATION.forEach((byte, k) => added.setUint8(8 + k, byte));
  added.setFloat64(8 + DURATION.length, duration);
  const parts = new Uint8Array(added.buffer);
  const pieces = [
    film.subarray(0, info + INFO.length),
    parts.subarray(0, 8),
    film.subarray(begin, end),
    parts.subarray(8),
    film.subarray(end),
  ];
  const whole = new Uint8Array(pieces.reduce((sum, {length}) => sum + length, 0));
  let at = 0;
  for (const piece of pieces) {
    whole.set(piece, at);
    at += piece.length;
  }
  return whole;
}
