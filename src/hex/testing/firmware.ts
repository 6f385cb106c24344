/** Small firmwares with the marks of true ones (real MicroPython is not ours to hand out), and their text. */
import type { HexBoard, Region } from '../firmware';

const VERSION_AT = 0x40;

/** The name that a board's firmware has for itself in these tests. */
export const versionOf = (board: HexBoard): string => `micro:bit test of ${board}; MicroPython v0`;

/** The text of a firmware without files, as a hex. */
export const firmwareText = (board: HexBoard): string => hexText(firmwareRegions(board));

/** The flash of a firmware without files. */
export function firmwareRegions(board: HexBoard): readonly Region[] {
  return board === 'microbit-v1' || board === 'calliope-mini-1' ? oldRegions(board) : newRegions(board);
}

/** The block that says how the flash is divided (UICR): as on a true board, 226 pages of 1 KiB and then files. */
function oldRegions(board: HexBoard): readonly Region[] {
  const uicr = new Uint8Array(28).fill(0xff);
  const view = new DataView(uicr.buffer);
  view.setUint32(0, 0x17eeb07c, true);
  view.setUint32(8, 10, true);
  view.setUint16(12, 0, true);
  view.setUint16(14, 226, true);
  view.setUint32(20, VERSION_AT, true);
  view.setUint32(24, 0, true);
  return [
    { address: 0, bytes: runtime(board, 0xc00) },
    { address: 0x100010c0, bytes: uicr },
  ];
}

/** Two pages of 4 KiB with the table at their end, files at 0x6D000 as on true boards, and something behind them. */
function newRegions(board: HexBoard): readonly Region[] {
  const bytes = runtime(board, 0x2000);
  const view = new DataView(bytes.buffer);
  const row = (
    place: number,
    [id, hashType, page, length, hash]: readonly [number, number, number, number, number],
  ) => {
    const at = 0x2000 - 16 * (place + 1);
    view.setUint8(at, id);
    view.setUint8(at + 1, hashType);
    view.setUint16(at + 2, page, true);
    view.setUint32(at + 4, length, true);
    view.setUint32(at + 8, hash, true);
    view.setUint32(at + 12, 0, true);
  };
  row(3, [1, 0, 0, 0x1000, 0]);
  row(2, [2, 2, 1, 0xf00, VERSION_AT]);
  row(1, [3, 0, 0x6d, 0x6000, 0]);
  bytes.set([0xfe, 0x30, 0x7f, 0x59, 1, 0, 48, 0, 3, 0, 12, 0, 0x9d, 0xd7, 0xb1, 0xc1], 0x1ff0);
  return [
    { address: 0, bytes },
    { address: 0x77000, bytes: Uint8Array.from({ length: 100 }, (_, index) => index) },
    { address: 0x10001014, bytes: Uint8Array.of(0, 0x70, 7, 0, 0, 0xe0, 7, 0) },
  ];
}

/** A runtime of zeros with its version, and the name that only Calliope's firmwares hold. */
function runtime(board: HexBoard, length: number): Uint8Array {
  const bytes = new Uint8Array(length);
  if (board === 'calliope-mini-3') bytes.set([0, 4, 0, 0x20, 0x81, 0x0a]);
  bytes.set(new TextEncoder().encode(versionOf(board)), VERSION_AT);
  if (board.startsWith('calliope')) bytes.set(new TextEncoder().encode('Calliope mini'), 0x100);
  return bytes;
}

/** The lines of a hex, without the one that ends it. */
export function linesOf(regions: readonly Region[], type = 0): readonly string[] {
  const lines: string[] = [];
  let upper = -1;
  for (const { address, bytes } of regions)
    for (let at = 0; at < bytes.length; at += 16) {
      const place = address + at;
      if (place >>> 16 !== upper) {
        upper = place >>> 16;
        lines.push(record(4, 0, [upper >>> 8, upper & 0xff]));
      }
      lines.push(record(type, place & 0xffff, [...bytes.subarray(at, at + 16)]));
    }
  return lines;
}

export const END = ':00000001FF';

export const hexText = (regions: readonly Region[]): string => `${[...linesOf(regions), END].join('\n')}\n`;

/** A line of a hex. */
export function record(type: number, offset: number, data: readonly number[]): string {
  const bytes = [data.length, offset >>> 8, offset & 0xff, type, ...data];
  const sum = bytes.reduce((all, byte) => all + byte, 0);
  return `:${[...bytes, -sum & 0xff].map((byte) => byte.toString(16).padStart(2, '0').toUpperCase()).join('')}`;
}

/** A script behind everything else, as the first editors put it. */
export function appended(script: string): Region {
  const text = new TextEncoder().encode(script);
  const bytes = new Uint8Array(Math.ceil((text.length + 4) / 16) * 16);
  bytes.set([0x4d, 0x50, text.length & 0xff, text.length >>> 8]);
  bytes.set(text, 4);
  return { address: 0x3e000, bytes };
}

/** A hex of MakeCode's first form: the source lies in the memory's addresses, behind the end. */
export const makeCodeText = (): string =>
  `${[...linesOf([{ address: 0, bytes: new Uint8Array(64) }]), END, record(4, 0, [0x20, 0]), record(0, 0, [0x41, 0x14, 0x0e, 0x2f, 0xb8, 0x2f, 0xa2, 0xbb])].join('\n')}\n`;

/** A hex of MakeCode for both boards: the source lies in records of its own. */
export const makeCodeUniversalText = (): string =>
  [
    record(4, 0, [0, 0]),
    record(10, 0, [0x99, 0x00, 0xc0, 0xde]),
    ...linesOf([{ address: 0, bytes: new Uint8Array(64) }]),
    record(11, 0, []),
    record(4, 0, [0, 0]),
    record(10, 0, [0x99, 0x03, 0xc0, 0xde]),
    ...linesOf([{ address: 0, bytes: new Uint8Array(64) }], 13),
    record(11, 0, []),
    record(14, 0, [0x41, 0x14, 0x0e, 0x2f, 0xb8, 0x2f, 0xa2, 0xbb]),
    END,
    '',
  ].join('\n');
