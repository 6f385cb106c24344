import { MicropythonFsHex } from '@microbit/microbit-fs';
import { describe, expect, it } from 'vitest';
import { cleanFirmware } from './clean';
import { hexBoards, type Firmware, type HexBoard } from './firmware';
import type { HexFile, MadeHex } from './hex';
import { makeHex } from './make';
import { readHex } from './read';
import {
  appended,
  END,
  firmwareRegions,
  firmwareText,
  hexText,
  linesOf,
  makeCodeText,
  makeCodeUniversalText,
  record,
  versionOf,
} from './testing/firmware';

const firmware = (text: string): Firmware => {
  const cleaned = cleanFirmware(text);
  const [only] = 'firmwares' in cleaned ? cleaned.firmwares : [];
  if (only === undefined) throw new Error(JSON.stringify(cleaned));
  return only;
};
const of = (board: HexBoard): Firmware => firmware(firmwareText(board));
const made = (firmwares: readonly Firmware[], files: readonly HexFile[]): Extract<MadeHex, { kind: 'hex' }> => {
  const hex = makeHex(firmwares, files);
  if (hex.kind !== 'hex') throw new Error(JSON.stringify(hex));
  return hex;
};
const files = [
  { name: 'main.py', text: 'from microbit import *\nimport way\n' },
  { name: 'way.py', text: 'x = 1\n'.repeat(100) },
  { name: 'täg.txt', text: 'grün 😀' },
];
const untilMultiple = 'x'.repeat(2 * 126 - 2 - 'main.py'.length);

describe('a firmware', () => {
  it.each(hexBoards)('of %s is known by its marks, with its words and its room', (board) => {
    const room = board.endsWith('1') ? 28_672 : 20_480;
    expect(of(board)).toMatchObject({ board, version: versionOf(board), known: null, roomBytes: room });
  });

  it('that holds files is the same without them: byte for byte', () => {
    for (const board of hexBoards) expect(firmware(made([of(board)], files).text)).toEqual(of(board));
  });

  it('with a script behind it is the same without it', () => {
    const text = hexText([...firmwareRegions('microbit-v1'), appended('print(1)')]);
    expect(firmware(text)).toEqual(of('microbit-v1'));
  });

  it('for several boards is one for each', () => {
    const cleaned = cleanFirmware(made([of('microbit-v2'), of('microbit-v1')], files).text);
    expect(cleaned).toEqual({ firmwares: [of('microbit-v1'), of('microbit-v2')] });
  });

  it('is not found in a hex without MicroPython, and MakeCode’s is told as such', () => {
    expect(cleanFirmware(hexText([{ address: 0, bytes: new Uint8Array(64) }]))).toEqual({ problem: { code: 'no-python' } }); // prettier-ignore
    expect(cleanFirmware(makeCodeText())).toEqual({ problem: { code: 'makecode' } });
    expect(cleanFirmware('print(1)')).toEqual({ problem: { code: 'no-hex' } });
  });
});

describe('a hex that is made', () => {
  it.each(hexBoards)('for %s is read back equal', (board) => {
    const read = readHex(made([of(board)], files).text);
    expect(read).toEqual({
      ...{ kind: 'hex', made: 'micropython', boards: [board], versions: [versionOf(board)], notes: [] },
      ...{ program: files[0]?.text, files },
    });
  });

  it('for both micro:bits is a universal hex: V1 comes first, under the number that every reader knows', () => {
    const hex = made([of('microbit-v2'), of('microbit-v1')], files);
    expect(hex.text.split('\n').slice(0, 2)).toEqual([':020000040000FA', ':0400000A9900C0DEBB']);
    expect(hex.text).toContain(':0400000A9903C0DEB8');
    expect(hex.boards).toEqual(['microbit-v1', 'microbit-v2']);
    expect(readHex(hex.text)).toMatchObject({ made: 'universal', boards: ['microbit-v1', 'microbit-v2'], files });
  });

  it('for a Calliope mini 3 alone begins with data: its app for Android knows it by that', () => {
    expect(made([of('calliope-mini-3')], files).text).toMatch(/^:1000000000040020810A/);
    expect(made([of('microbit-v2')], files).text).toMatch(/^:020000040000FA\n/);
    expect(made([of('calliope-mini-1'), of('calliope-mini-3')], files).text).toMatch(/^:020000040000FA\n:0400000A9900/);
  });

  it('keeps the table of the flash in one line, where the apps look for it', () => {
    for (const board of ['microbit-v2', 'calliope-mini-3'] as const)
      expect(made([of(board)], files).text).toMatch(/^:10[0-9A-F]{6}FE307F59[0-9A-F]{16}9DD7B1C1/m);
  });

  it('gives an empty file a line end, since boards hold none that is empty', () => {
    const hex = made([of('microbit-v2')], [...files, { name: 'empty.py', text: '' }]);
    expect(hex.filled).toEqual(['empty.py']);
    expect(readHex(hex.text)).toMatchObject({ files: [...files, { name: 'empty.py', text: '\n' }] });
  });

  it('holds a file that ends with the last byte of a chunk', () => {
    const [file] = [{ name: 'main.py', text: untilMultiple }];
    for (const board of hexBoards) expect(readHex(made([of(board)], [file]).text)).toMatchObject({ files: [file] });
  });

  it('says by how many bytes its files are too large, and what is large', () => {
    const most = { name: 'main.py', text: 'x'.repeat(20_150) };
    expect(made([of('microbit-v2')], [most])).toMatchObject({ usedBytes: 20_480, roomBytes: 20_480 });
    expect(
      makeHex(
        [of('microbit-v2')],
        [
          { name: 'a.py', text: '1' },
          { ...most, text: `${most.text}x` },
        ],
      ),
    ).toEqual({
      ...{ kind: 'too-large', missingBytes: 256, roomBytes: 20_480 },
      large: [
        { name: 'main.py', bytes: 20_608 },
        { name: 'a.py', bytes: 128 },
      ],
    });
  });

  it('takes the smallest room of its boards', () => {
    expect(makeHex([of('microbit-v1'), of('microbit-v2')], [{ name: 'main.py', text: 'x'.repeat(25_000) }])).toMatchObject({ kind: 'too-large', roomBytes: 20_480 }); // prettier-ignore
    expect(makeHex([of('microbit-v1')], [{ name: 'main.py', text: 'x'.repeat(25_000) }]).kind).toBe('hex');
  });

  it('refuses names that a board cannot hold', () => {
    const named = (...names: readonly string[]) => makeHex([of('microbit-v2')], names.map((name) => ({ name, text: '1' }))); // prettier-ignore
    expect(named('ä'.repeat(60)).kind).toBe('hex');
    expect(named('ä'.repeat(61))).toMatchObject({ kind: 'name' });
    expect(named('')).toEqual({ kind: 'name', name: '' });
    expect(named('a.py', 'a.py')).toEqual({ kind: 'name', name: 'a.py' });
  });

  it('is not made for boards of two families, or twice for one', () => {
    const boards = (...all: readonly HexBoard[]) => makeHex(all.map(of), files).kind;
    expect(boards('microbit-v1', 'calliope-mini-3')).toBe('boards');
    expect(boards('microbit-v2', 'microbit-v2')).toBe('boards');
    expect(boards()).toBe('boards');
  });

  it('is read by the library of the micro:bit Educational Foundation', () => {
    for (const boards of [
      ['microbit-v1'],
      ['microbit-v2'],
      ['calliope-mini-3'],
      ['microbit-v1', 'microbit-v2'],
    ] as const) {
      // prettier-ignore
      const reader = new MicropythonFsHex(firmwareText('microbit-v2'));
      reader.importFilesFromHex(made(boards.map(of), files).text);
      expect(reader.ls().map((name) => ({ name, text: reader.read(name) }))).toEqual(files);
    }
  });
});

describe('a hex that is read', () => {
  const hex = made([of('microbit-v2')], files).text;

  it('may have the line ends of Windows, a mark at its beginning, and small letters', () => {
    for (const text of [hex.replaceAll('\n', '\r\n'), `\ufeff${hex}`, hex.toLowerCase()])
      expect(readHex(text)).toEqual(readHex(hex));
  });

  it('may be one of the first Python: its script lies behind everything else', () => {
    const old = [{ address: 0, bytes: new Uint8Array(64) }, appended('print("ä")\n')];
    const lines = [...linesOf(old.slice(0, 1)), ':'.repeat(43), ...linesOf(old.slice(1)), END, ''].join('\n');
    const one = [{ name: 'main.py', text: 'print("ä")\n' }];
    expect(readHex(lines)).toMatchObject({ made: 'micropython-appended', boards: ['microbit-v1'], files: one });
    const later = hexText([...firmwareRegions('microbit-v1'), appended('print("ä")\n')].toSorted((a, b) => a.address - b.address)); // prettier-ignore
    expect(readHex(later)).toMatchObject({ made: 'micropython-appended', files: one });
  });

  it('may be one of uflash and Mu, which number the chunks of a V1 from the second page on', () => {
    const script = 'x = 1\n'.repeat(30);
    const bytes = new Uint8Array(256).fill(0xff);
    bytes.set([0xfe, 9 + script.length - 126, 7, ...new TextEncoder().encode(`main.py${script.slice(0, 117)}`), 2, 1]);
    bytes.set(new TextEncoder().encode(script.slice(117)), 129);
    const text = hexText([...firmwareRegions('microbit-v1').slice(0, 1), { address: 0x38c00, bytes }, ...firmwareRegions('microbit-v1').slice(1)]); // prettier-ignore
    expect(readHex(text)).toMatchObject({ files: [{ name: 'main.py', text: script }] });
  });

  it('may be universal with the number that older editors gave the V1', () => {
    const part = (id: number, board: HexBoard, type: number) => [
      record(4, 0, [0, 0]),
      record(10, 0, [0x99, id, 0xc0, 0xde]),
      ...linesOf(firmwareRegions(board), type),
      record(12, 0, [0xff, 0xff]),
      record(11, 0, []),
    ];
    const text = [...part(1, 'microbit-v1', 0), ...part(3, 'microbit-v2', 13), END, ''].join('\n');
    expect(readHex(text)).toMatchObject({ made: 'universal', boards: ['microbit-v1', 'microbit-v2'] });
  });

  it('is told as MakeCode’s', () => {
    expect(readHex(makeCodeText())).toMatchObject({ made: 'makecode', boards: [], program: null, files: [] });
    expect(readHex(makeCodeUniversalText())).toMatchObject({
      made: 'makecode',
      boards: ['microbit-v1', 'microbit-v2'],
    });
  });

  it('is told as something unknown, or as MicroPython without a file', () => {
    expect(readHex(hexText([{ address: 0, bytes: new Uint8Array(64) }]))).toMatchObject({ made: 'unknown', notes: [] });
    expect(readHex(firmwareText('microbit-v2'))).toMatchObject({ made: 'micropython', files: [], notes: [{ code: 'no-files' }] }); // prettier-ignore
  });

  it('leaves out a file that is no text, and says so', () => {
    const reader = new MicropythonFsHex(firmwareText('microbit-v2'));
    reader.write('main.py', 'x = 1\n');
    reader.write('sound.raw', Uint8Array.of(0xff, 0xfe, 0));
    expect(readHex(reader.getIntelHex())).toMatchObject({
      files: [{ name: 'main.py', text: 'x = 1\n' }],
      notes: [{ code: 'not-text', file: 'sound.raw' }],
    });
  });

  it('is refused with the number of a damaged line', () => {
    const lines = hex.split('\n');
    const broken = (line: string) => readHex([...lines.slice(0, 6), line, ...lines.slice(7)].join('\n'));
    const whole = lines[6] ?? '';
    const problem = { kind: 'problem', problem: { code: 'line', line: 7 } };
    for (const line of [
      whole.slice(0, -2),
      whole.slice(0, -1),
      `${whole.slice(0, -2)}00`,
      whole.replace('0', 'G'),
      'x',
      ':',
      record(6, 0, []),
    ])
      // prettier-ignore
      expect(broken(line === whole ? 'x' : line)).toEqual(problem);
    expect(readHex([...lines.slice(0, 3), lines[1], ...lines.slice(3)].join('\n'))).toMatchObject({ problem: { code: 'line' } }); // prettier-ignore
  });

  it('is refused if it breaks off, is no hex, or its files are damaged', () => {
    const problemOf = (text: string) => {
      const read = readHex(text);
      return read.kind === 'problem' ? read.problem.code : null;
    };
    expect(problemOf(hex.slice(0, hex.indexOf('\n', 20_000)))).toBe('cut');
    expect(problemOf('')).toBe('no-hex');
    expect(problemOf('from microbit import *')).toBe('no-hex');
    const chunk = Uint8Array.of(0xfe, 20, 7, ...new Uint8Array(124), 9);
    expect(problemOf(hexText([...firmwareRegions('microbit-v2'), { address: 0x6d000, bytes: chunk }]))).toBe('files');
  });
});
