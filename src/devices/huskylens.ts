/**
 * An AI camera DFRobot HuskyLens (SEN0305) on the I2C bus. Requests and replies are frames:
 *
 *      55 AA 11  n  command  data …  sum      n = number of data bytes; sum = low byte of the sum of all before it
 *
 * Bytes come one after the other: any number of transfers may take a frame apart, and what begins no frame is skipped. A
 * frame with a wrong sum, or with a command that it does not know, is not answered. The reply is a stream as well; a new
 * request drops what is left of it, and 00 comes while there is nothing to say. Words have their low byte first.
 *
 *      command   data         reply
 *      2C        –            2E: knock, it is there
 *      20 21 22  –            29, then 2A for each block and 2B for each arrow; 21 blocks alone, 22 arrows alone
 *      23 24 25  –            the same of what has an id
 *      26 27 28  word id      the same of what has this id
 *      2D        word n       2E: algorithm n from now on; 3E: that one is of the Pro alone (7, 8)
 *      36        word id      2E: what is in the middle has this id from now on
 *      37        –            2E: nothing has an id any more
 *      3B        –            3B 00 00: it is no Pro
 *      2F 30 32 33 34 35 39 3C  2E: names, texts, photos and models change nothing here
 *
 *      29        words: results, ids that are known, number of the picture, 0, 0
 *      2A        words: x and y of the middle, width, height, id
 *      2B        words: x and y of the tail, x and y of the head, id
 *
 * The picture is 320 × 240, y grows downwards; id 0 is seen, but not learned.
 *
 * Source: the maker's description of the protocol, version 0.5.1. What it leaves open is chosen: docs/hardware/huskylens.md.
 */
import type { I2cBus, I2cTarget } from '#board/wires/i2c-bus';
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

export const HUSKYLENS_ADDRESS = 0x32;

/** Extent of its picture. */
export const HUSKYLENS_PICTURE = { width: 320, height: 240 } as const;

/** Its algorithms by their numbers. What has no things in an arena sees none: faces, objects. */
export const huskyAlgorithms = ['face', 'track', 'object', 'line', 'colour', 'tag', 'classify'] as const;
export type HuskyAlgorithm = (typeof huskyAlgorithms)[number];

/** A block or an arrow in its picture. */
export type HuskyResult = HuskyBlock | HuskyArrow;

/** A thing in a box. */
export interface HuskyBlock {
  readonly kind: 'block';
  /** The middle. */
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  /** The thing's own number, from 1 on, until the camera forgets. */
  readonly id: number;
}

/** A line, from near to far. */
export interface HuskyArrow {
  readonly kind: 'arrow';
  readonly tail: readonly [x: number, y: number];
  readonly head: readonly [x: number, y: number];
  readonly id: number;
}

/** The sight of an algorithm in the present picture. */
export type HuskyLook = (algorithm: HuskyAlgorithm) => readonly HuskyResult[];

/** One camera as its owner sees it. */
export interface HuskyLens {
  readonly algorithm: () => HuskyAlgorithm;
  /** The results of the last request, if it came within this time; `null`: there was none. */
  readonly seenWithin: (us: number) => readonly HuskyResult[] | null;
  readonly stop: Stop;
}

const HEADER = [0x55, 0xaa, 0x11] as const;
const [ALL, INFO, BLOCK, ARROW] = [0x20, 0x29, 0x2a, 0x2b];
const [KNOCK, ALGORITHM, OK, LEARN, FORGET, IS_PRO, NEED_PRO] = [0x2c, 0x2d, 0x2e, 0x36, 0x37, 0x3b, 0x3e];
/** Names, photos, models, texts, the version of its program: it agrees. */
const AGREED: readonly number[] = [KNOCK, 0x2f, 0x30, 0x32, 0x33, 0x34, 0x35, 0x39, 0x3c];
/** Algorithms of the Pro: QR codes and bar codes. */
const PRO: readonly number[] = [7, 8];

/** It takes 30 pictures a second. Maker's page. */
export const HUSKYLENS_PICTURE_US = 33_333;
/** Ids that it counts as known while it has not forgotten them, by what there is to know: docs/hardware/huskylens.md. */
const KNOWN: Readonly<Record<HuskyAlgorithm, number>> = { face: 0, track: 0, object: 0, line: 1, colour: 7, tag: 99, classify: 0 }; // prettier-ignore

/** Puts a camera on the bus. Nothing is looked at until a program asks. */
export function attachHuskyLens(clock: Clock, bus: I2cBus, look: HuskyLook, start: HuskyAlgorithm): HuskyLens {
  const camera = createCamera(clock, look, start);
  const stop = bus.attach(HUSKYLENS_ADDRESS, createTarget(camera.answer));
  return { algorithm: camera.algorithm, seenWithin: camera.seenWithin, stop };
}

/** The camera's end of the bus. */
function createTarget(answer: Answer): I2cTarget {
  let reply: number[] = [];
  let taken = 0;
  const receive = createFrameReader((command, data) => {
    reply = answer(command, data).flatMap(({ command, data }) => frameOf(command, data));
    taken = 0;
  });
  return {
    write: (bytes) => {
      for (const byte of bytes) receive(byte);
    },
    read: (count) => {
      const bytes = new Uint8Array(count);
      bytes.set(reply.slice(taken, taken + count));
      taken += count;
      return bytes;
    },
  };
}

/** A frame as it is sent. */
export function frameOf(command: number, data: readonly number[]): number[] {
  const bytes = [...HEADER, data.length, command, ...data];
  return [...bytes, bytes.reduce((sum, byte) => sum + byte, 0) & 0xff];
}

/** Takes frames from single bytes: calls `got` with each that is whole and right. */
export function createFrameReader(got: (command: number, data: readonly number[]) => void): (byte: number) => void {
  let frame: number[] = [];
  return (byte) => {
    const place = frame.length;
    frame.push(byte);
    if (place < HEADER.length && byte !== HEADER[place]) {
      frame = byte === HEADER[0] ? [byte] : []; // the first byte of the next one, perhaps
      return;
    }
    const [, , , count = 0, command = 0] = frame;
    if (frame.length < 6 + count) return;
    const data = frame.slice(5, 5 + count);
    const isRight = frameOf(command, data)[5 + count] === byte;
    frame = [];
    if (isRight) got(command, data);
  };
}

interface Frame {
  readonly command: number;
  readonly data: readonly number[];
}
/** The frames that answer a request; none: it is not answered. */
type Answer = (command: number, data: readonly number[]) => readonly Frame[];

const bare = (command: number): readonly Frame[] => [{ command, data: [] }];

interface Camera {
  readonly answer: Answer;
  readonly algorithm: () => HuskyAlgorithm;
  readonly seenWithin: HuskyLens['seenWithin'];
}

function createCamera(clock: Clock, look: HuskyLook, start: HuskyAlgorithm): Camera {
  let algorithm = start;
  let picture: { readonly number: number; readonly of: HuskyAlgorithm; readonly found: readonly HuskyResult[] } | null =
    null;
  let asked: { readonly atUs: number; readonly results: readonly HuskyResult[] } | null = null;
  const memories = new Map<HuskyAlgorithm, Memory>();
  const memory = (): Memory => memories.get(algorithm) ?? 'given';

  const found = (): readonly HuskyResult[] => {
    const number = Math.floor(clock.nowUs / HUSKYLENS_PICTURE_US);
    if (picture?.number !== number || picture.of !== algorithm) {
      picture = { number, of: algorithm, found: look(algorithm) };
    }
    return picture.found;
  };
  const results = (): readonly HuskyResult[] => {
    const ids = memory();
    return ids === 'given' ? found() : found().flatMap((one) => remembered(one, ids, algorithm));
  };
  const request = (command: number, wanted: number): readonly Frame[] => {
    const [which, kind] = [Math.floor((command - ALL) / 3), (command - ALL) % 3];
    const all = results().filter(
      ({ id, kind: of }) =>
        (which === 0 || (which === 1 ? id > 0 : id === wanted)) &&
        (kind === 0 || of === (kind === 1 ? 'block' : 'arrow')),
    );
    asked = { atUs: clock.nowUs, results: all };
    const ids = memory();
    const known = ids === 'given' ? KNOWN[algorithm] : ids.size;
    const info = [all.length, known, Math.floor(clock.nowUs / HUSKYLENS_PICTURE_US) & 0xffff, 0, 0];
    return [{ command: INFO, data: wordsOf(info) }, ...all.map(toFrame)];
  };
  const answer: Answer = (command, data) => {
    const word = (data[0] ?? 0) + 256 * (data[1] ?? 0);
    if (command >= ALL && command < INFO) return request(command, word);
    if (command === ALGORITHM) {
      const wished = huskyAlgorithms[word];
      if (wished === undefined) return PRO.includes(word) ? bare(NEED_PRO) : [];
      algorithm = wished;
      return bare(OK);
    }
    if (command === LEARN) {
      const middle = nearestToMiddle(found());
      const ids = memory();
      if (middle !== null) memories.set(algorithm, new Map(ids === 'given' ? [] : ids).set(middle.id, word));
      return bare(OK);
    }
    if (command === FORGET) {
      memories.set(algorithm, new Map());
      return bare(OK);
    }
    if (command === IS_PRO) return [{ command, data: [0, 0] }];
    return AGREED.includes(command) ? bare(OK) : [];
  };
  return {
    answer,
    algorithm: () => algorithm,
    seenWithin: (us) => (asked !== null && clock.nowUs - asked.atUs <= us ? asked.results : null),
  };
}

/** The ids that an algorithm has learned: number of a thing → its id; `given`: things have the ids that the arena says. */
type Memory = 'given' | ReadonlyMap<number, number>;

/** A result with the id that was learned for it; a colour that was not learned is no result. */
function remembered(one: HuskyResult, ids: ReadonlyMap<number, number>, of: HuskyAlgorithm): readonly HuskyResult[] {
  const id = ids.get(one.id) ?? 0;
  return id === 0 && of === 'colour' ? [] : [{ ...one, id }];
}

/** The result whose middle is nearest to that of the picture. */
function nearestToMiddle(results: readonly HuskyResult[]): HuskyResult | null {
  const off = (one: HuskyResult): number => {
    const [x, y] =
      one.kind === 'block' ? [one.x, one.y] : [(one.tail[0] + one.head[0]) / 2, (one.tail[1] + one.head[1]) / 2];
    const [across, down] = [x - HUSKYLENS_PICTURE.width / 2, y - HUSKYLENS_PICTURE.height / 2];
    return across * across + down * down;
  };
  return results.reduce<HuskyResult | null>((best, one) => (best === null || off(one) < off(best) ? one : best), null);
}

const toFrame = (result: HuskyResult): Frame =>
  result.kind === 'block'
    ? { command: BLOCK, data: wordsOf([result.x, result.y, result.width, result.height, result.id]) }
    : { command: ARROW, data: wordsOf([...result.tail, ...result.head, result.id]) };

const wordsOf = (words: readonly number[]): number[] => words.flatMap((word) => [word & 0xff, (word >> 8) & 0xff]);
