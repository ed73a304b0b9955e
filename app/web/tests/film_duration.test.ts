// Tests of the duration of a recorded film: it is added once, and all else is kept.
import {describe, expect, it} from "vitest";
import {withDuration} from "../source/arm/film_duration";

const HEAD = [0x1a, 0x45, 0xdf, 0xa3, 0x80],
  INFO = [0x15, 0x49, 0xa9, 0x66],
  SCALE = [0x2a, 0xd7, 0xb1, 0x83, 0x0f, 0x42, 0x40],
  REST = [0x16, 0x54, 0xae, 0x6b, 0x81, 0x00];
const DURATION = [0x44, 0x89, 0x88, 0x40, 0x9f, 0x40, 0, 0, 0, 0, 0]; // 2000 ms

describe("the duration of a film", () => {
  it("follows what the film states of itself", () => {
    for (const size of [[0x87], [0x40, 0x07], [0x01, 0, 0, 0, 0, 0, 0, 7]]) {
      const film = Uint8Array.from([...HEAD, ...INFO, ...size, ...SCALE, ...REST]);
      expect([...withDuration(film, 2000)]).toEqual(
        [HEAD, INFO, [0x01, 0, 0, 0, 0, 0, 0, 18], SCALE, DURATION, REST].flat(),
      );
    }
  });
  it("is not added twice, and not to another format", () => {
    const once = withDuration(Uint8Array.from([...HEAD, ...INFO, 0x87, ...SCALE, ...REST]), 2000);
    for (const film of [once, Uint8Array.from([0, 0, 0, 1]), Uint8Array.from([...INFO, 0xff, ...SCALE])])
      expect(withDuration(film, 3000)).toBe(film);
  });
});
