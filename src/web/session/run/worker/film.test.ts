import { describe, expect, it } from 'vitest';

import { createFilmMaker, Film, type FromFilm, type Pixels } from './film';

const [RED, WHITE, BLUE] = [
  [255, 0, 0],
  [255, 255, 255],
  [0, 0, 255],
] as const;
const SIZE = 20;

/** A picture of one colour, with another one in its first `count` pixels. */
function picture(ground: readonly number[], over: readonly number[] = ground, count = 0): Pixels {
  const pixels = new Uint8ClampedArray(4 * SIZE * SIZE);
  for (let at = 0; at < SIZE * SIZE; at++) pixels.set([...(at < count ? over : ground), 255], 4 * at);
  return pixels;
}

/** The contents of a GIF, read by the rules of the format (GIF89a), not by those of the writer. */
function readGif(bytes: Uint8Array) {
  const text = (from: number, to: number): string => String.fromCharCode(...bytes.slice(from, to));
  const size = [bytes[6]! + 256 * bytes[7]!, bytes[8]! + 256 * bytes[9]!];
  let at = 13 + 3 * 2 ** ((bytes[10]! & 7) + 1);
  const blocks = (): number => {
    let length = 0;
    for (; bytes[at] !== 0; at += bytes[at]! + 1) length += bytes[at]!;
    at += 1;
    return length;
  };
  const delays: number[] = [];
  const lengths: number[] = [];
  let isRepeated = false;
  for (; bytes[at] !== 0x3b;) {
    if (bytes[at] === 0x21 && bytes[at + 1] === 0xf9) delays.push(10 * (bytes[at + 4]! + 256 * bytes[at + 5]!));
    if (bytes[at] === 0x21 && bytes[at + 1] === 0xff) isRepeated = text(at + 3, at + 11) === 'NETSCAPE';
    if (bytes[at] === 0x21) {
      at += 2;
      blocks();
    } else if (bytes[at] === 0x2c) {
      const own = bytes[at + 9]!;
      at += 11 + (own & 128 ? 3 * 2 ** ((own & 7) + 1) : 0);
      lengths.push(blocks());
    } else throw new Error(`no block at ${at}`);
  }
  return { sign: text(0, 6), size, delays, lengths, isRepeated, isWhole: at === bytes.length - 1 };
}

describe('a film', () => {
  it('is a GIF of its size that begins again, with the time of each picture', () => {
    const film = new Film(SIZE, SIZE, [picture(WHITE)]);
    film.add(picture(WHITE), 80);
    film.add(picture(WHITE, RED, 30), 80);
    film.add(picture(WHITE, BLUE, 30), 1500);
    expect(readGif(film.end())).toMatchObject({
      ...{ sign: 'GIF89a', size: [SIZE, SIZE], delays: [80, 80, 1500], isRepeated: true, isWhole: true },
    });
  });

  it('writes only what has changed: a picture in which nothing has takes next to nothing', () => {
    const noise = Uint8ClampedArray.from({ length: 4 * SIZE * SIZE }, (_, n) =>
      n % 4 === 3 ? 255 : (n * n * 7) % 256,
    );
    const film = new Film(SIZE, SIZE, [noise]);
    film.add(noise.slice(), 80);
    film.add(noise.slice(), 80);
    const { lengths } = readGif(film.end());
    expect(lengths[1]).toBeLessThan(lengths[0]! / 4);
  });
});

describe('the worker of a film', () => {
  function maker() {
    const heard: FromFilm[] = [];
    return { heard, tell: createFilmMaker((message) => heard.push(message)) };
  }

  it('takes picture after picture, and gives the film at its end', () => {
    const { heard, tell } = maker();
    tell({ type: 'film-begin', width: SIZE, height: SIZE, samples: [picture(WHITE), picture(RED)] });
    for (const colour of [WHITE, RED, BLUE]) tell({ type: 'film-picture', pixels: picture(colour), staysMs: 80 });
    tell({ type: 'film-end' });
    expect(heard.map(({ type }) => type)).toEqual(['film-taken', 'film-taken', 'film-taken', 'film-made']);
    const last = heard.at(-1);
    expect(last?.type === 'film-made' && readGif(last.gif).delays).toEqual([80, 80, 80]);
  });

  it('says what went wrong', () => {
    const { heard, tell } = maker();
    tell({ type: 'film-end' });
    expect(heard).toEqual([{ type: 'film-failed', message: 'The film has not begun.' }]);
  });
});
