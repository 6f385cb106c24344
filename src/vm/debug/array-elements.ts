import type { Memory } from '../run/values';

type Reader = (view: DataView, at: number) => string | number;

const whole =
  (read: (view: DataView, at: number) => number | bigint): Reader =>
  (view, at) =>
    String(read(view, at));

/** How to read an element of each type of an `array`, and its number of bytes: py/binary.c, for 32-bit words. */
const READERS: Readonly<Record<string, readonly [bytes: number, read: Reader]>> = {
  b: [1, whole((view, at) => view.getInt8(at))],
  B: [1, whole((view, at) => view.getUint8(at))],
  h: [2, whole((view, at) => view.getInt16(at, true))],
  H: [2, whole((view, at) => view.getUint16(at, true))],
  i: [4, whole((view, at) => view.getInt32(at, true))],
  I: [4, whole((view, at) => view.getUint32(at, true))],
  l: [4, whole((view, at) => view.getInt32(at, true))],
  L: [4, whole((view, at) => view.getUint32(at, true))],
  q: [8, whole((view, at) => view.getBigInt64(at, true))],
  Q: [8, whole((view, at) => view.getBigUint64(at, true))],
  f: [4, (view, at) => view.getFloat32(at, true)],
  d: [8, (view, at) => Math.fround(view.getFloat64(at, true))],
};

/** Elements of an array: whole numbers as text, floats as numbers. Empty if the type is not known. */
export function elementsAt(memory: Memory, letter: string, start: number, count: number): readonly (string | number)[] {
  const reader = READERS[letter];
  if (reader === undefined) return [];
  const [bytes, read] = reader;
  const view = new DataView(memory.bytes.buffer);
  return Array.from({ length: count }, (_, place) => read(view, start + bytes * place));
}
