import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import type { BoardType, FirmwareType } from '#board/boards/board-type';
import { boardTypes } from '#board/boards/index';
import { boardModules } from '#reference/modules/index';
import type { Names, ReferenceModule } from '#reference/types';
import { play } from './testing/play';

/** How a program comes by a value of a type whose names only its values have, or that has no name of its own. */
const VALUES: Readonly<Record<string, string>> = {
  'microbit.Button': 'microbit.button_a',
  'microbit.MicroBitDigitalPin': 'microbit.pin8',
  'microbit.MicroBitAnalogDigitalPin': 'microbit.pin4',
  'microbit.MicroBitTouchOnlyPin': 'microbit.pin_logo',
  'audio.SoundEffect': 'audio.SoundEffect()',
  'audio.AudioRecording': 'audio.AudioRecording(10)',
  'audio.AudioTrack': 'audio.AudioRecording(10).track()',
  'neopixel.NeoPixel': 'neopixel.NeoPixel(microbit.pin0, 1)',
  'os.uname_result': 'os.uname()',
  'array.array': "array.array('b')",
  'builtins.file': "open('main.py')",
  'builtins.generator': '(i for i in ())',
  'builtins.range': 'range(1)',
  'builtins.complex': 'complex(1)',
  'builtins.property': 'property(len)',
  'builtins.OSError': 'OSError(1)',
};

/** A name, as the documentation writes it, and where a program finds it. */
interface Sought {
  readonly name: string;
  readonly expression: string;
}

/** The names that a board's newest firmware should have, and those that only type hints list. */
function soughtIn(names: Names, path: string, root: string, type: BoardType): Sought[] {
  return Object.entries(names).flatMap(([name, entry]) => {
    if (entry.boards?.some((id) => id === type.id) === false) return [];
    if (entry.feature !== undefined && !newest(type).features.includes(entry.feature)) return [];
    const inner = `${path}.${name}`;
    const key = inner.replace(/^calliope_?mini\b/, 'microbit');
    const isException = entry.kind === 'exception' && !(key in VALUES);
    const value = isException ? `${name}()` : (VALUES[key] ?? `${root}.${name}`);
    return [{ name: inner, expression: `${root}.${name}` }, ...soughtIn(entry.members, inner, value, type)];
  });
}

const newest = ({ firmwares }: BoardType): FirmwareType => firmwares.at(-1) ?? firmwares[0];

const namesOf = (module: ReferenceModule, name: string, type: BoardType): Sought[] => [
  { name, expression: name },
  ...soughtIn(module.names, name, name, type),
];

/** The names out of these that a program on the real VM does not find. */
function notFound(sought: readonly Sought[], module: string, type: BoardType): string[] {
  const main = type.modules[0] ?? '';
  const program = [
    `import ${main} as microbit`,
    'import sys, os, array, builtins',
    'try:',
    '    import audio, neopixel',
    `    import ${module}`,
    'except ImportError:',
    `    print('?', '${module}')`,
    "with open('names.txt') as f:",
    '    text = f.read()',
    "for line in text.split('\\n'):",
    '    try:',
    '        eval(line)',
    '    except (NameError, AttributeError, ImportError, TypeError) as e:',
    "        print('?', line)",
    "print('the end')",
  ].join('\n');
  const missing: string[] = [];
  // Bit by bit: all names at once would not fit on the board.
  for (let from = 0; from < sought.length; from += 100) {
    const part = sought.slice(from, from + 100);
    const files = { 'names.txt': part.map((it) => it.expression).join('\n') };
    const run = play(program, files, () => undefined, { type, firmware: newest(type) }).until(120_000);
    expect(run.printed().trimEnd().split('\n').at(-1), run.printed().slice(-300)).toBe('the end');
    const lines = run.printed().split('\n');
    missing.push(...part.filter((it) => lines.includes(`? ${it.expression}`)).map((it) => it.name));
  }
  return missing;
}

/** The names in the first column of the tables of what is missing. */
const documented = [
  ...readFileSync(new URL('../../../docs/api-coverage.md', import.meta.url), 'utf8').matchAll(/^\| (`[^|]+) \|/gm),
].flatMap(([, names = '']) => Array.from(names.matchAll(/`([^`]+)`/g), ([, name = '']) => name));

describe.each(boardTypes)('the API of the $name with its newest firmware', (type) => {
  const modules = boardModules.filter(({ boards }) => boards?.some((id) => id === type.id) !== false);
  const missingOf = (module: ReferenceModule): string[] =>
    notFound(namesOf(module, module.name, type), module.name, type);

  it.each(modules.map((module) => [module.name, module] as const))(
    'has every name of %s but those that docs/api-coverage.md lists with a reason',
    (name, module) => {
      const here = documented.filter((it) => it.split('.')[0] === name);
      expect(missingOf(module).sort()).toEqual(here.sort());
      for (const alias of module.aliases) {
        const missing = notFound(namesOf(module, alias, type), alias, type);
        const known = here.map((it) => it.replace(name, alias));
        expect(missing.filter((it) => !known.includes(it))).toEqual([]);
      }
    },
  );

  it('has all names that the firmware has, which is more than the 99 % that are promised', () => {
    const all = modules.flatMap((module) => namesOf(module, module.name, type));
    const missing = modules.flatMap(missingOf);
    const inFirmware = new Set(modules.flatMap((module) => presentIn(module.names, module.name)));
    expect(inFirmware.size).toBeGreaterThan(600);
    expect(missing.filter((name) => inFirmware.has(name))).toEqual([]);
    expect(all.length - missing.length).toBeGreaterThan(inFirmware.size);
  });
});

/** Names that are not marked as absent, themselves or by what they belong to. */
function presentIn(names: Names, path: string): string[] {
  return Object.entries(names).flatMap(([name, entry]) =>
    entry.absent === true ? [] : [`${path}.${name}`, ...presentIn(entry.members, `${path}.${name}`)],
  );
}
