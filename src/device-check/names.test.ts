import { describe, expect, it } from 'vitest';
import type { BoardType, FirmwareType } from '#board/boards/board-type';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { boardModules } from '#reference/modules/index';
import type { Names } from '#reference/types';
import { play } from '#vm/library/testing/play';
import { checkForDevice } from './check-for-device';

/** Values of the types of the language, by which a program finds their names. */
const VALUES: Readonly<Record<string, string>> = {
  str: '""',
  bytes: 'b""',
  bytearray: 'bytearray(2)',
  memoryview: 'memoryview(b"")',
  list: '[]',
  tuple: '()',
  dict: '{}',
  set: 'set()',
  frozenset: 'frozenset()',
  int: '(1)',
  float: '(1.5)',
  complex: '(1j)',
  range: 'range(1)',
  object: 'object',
  property: 'property(len)',
};

/** Names that no table of the project lists, and that the board has all the same: where its source says so. */
const UNLISTED: readonly (readonly [names: RegExp, source: string])[] = [
  [/\.__(class|name|dict|bases)__$/, 'py/objmodule.c, py/objtype.c: every module, type and object with CPYTHON_COMPAT'],
  [/^(object|random)\.__(init|new)__$/, 'py/objobject.c: CPYTHON_COMPAT; extmod/modrandom.c: MODULE_BUILTIN_INIT'],
  [/^(dict|collections\.OrderedDict)\.__(get|set|del)item__$/, 'py/objdict.c, dict_locals_dict_table'],
  [/^(frozen)?set\.__contains__$/, 'py/objset.c, set_locals_dict_table'],
  [/^bytes\.format$/, 'py/objstr.c: bytes shares its table with str'],
  [/^neopixel\.(NeoPixel\.ORDER|ws2812_write)$/, 'src/codal_app/modules/neopixel.py'],
  [
    /^bytearray\.(count|endswith|find|format|index|is\w+|join|lower|[lr]?strip|replace|r?find|r?index|r?split|startswith|upper)$/,
    'py/objarray.c since 1.20: the methods of bytes',
  ],
];

interface Tried {
  readonly type: BoardType;
  readonly firmware: FirmwareType;
}

const boards = [
  { name: 'micro:bit V2', type: microbitV2, firmware: microbitV2.firmwares[0] },
  { name: 'micro:bit V2 with its newest firmware', type: microbitV2, firmware: microbitV2.firmwares.at(-1) },
  { name: 'Calliope mini 3', type: calliopeMini3, firmware: calliopeMini3.firmwares[0] },
].flatMap(({ firmware, ...rest }) => (firmware === undefined ? [] : [{ ...rest, firmware }]));

/** The names that the board's tables have. */
function known(names: Names, { type, firmware }: Tried): Set<string> {
  const has = Object.entries(names).filter(
    ([, { boards: only, feature, absent }]) =>
      absent !== true &&
      only?.some((id) => id === type.id) !== false &&
      (feature === undefined || firmware.features.includes(feature)),
  );
  return new Set(has.map(([name]) => name));
}

/** The output of dir() for some expressions, on the VM as this board. */
function listed(expressions: readonly string[], imports: string, { type, firmware }: Tried): string[][] {
  const program = `${imports}\n${expressions.map((it) => `print(" ".join(dir(${it})))`).join('\n')}`;
  const run = play(program, {}, () => undefined, { type, firmware }).until(5000);
  expect(run.ended(), run.printed()).toEqual({ kind: 'finished', exception: null });
  const lines = run.printed().trimEnd().split('\n').slice(-expressions.length);
  return lines.map((line) => line.split(' ').filter((it) => it !== ''));
}

/** A name that our VM has and the board's tables have not, with a program that uses it. */
interface Extra {
  readonly name: string;
  readonly program: string;
}

function extrasOf(tried: Tried): Extra[] {
  const builtins = boardModules.find(({ name }) => name === 'builtins')?.names ?? {};
  const types = Object.keys(VALUES);
  const ofTypes = listed(
    types.map((it) => VALUES[it] ?? it),
    '',
    tried,
  ).flatMap((names, index) => {
    const type = types[index] ?? '';
    const here = known(builtins[type]?.members ?? {}, tried);
    return names
      .filter((it) => !here.has(it))
      .map((it) => ({ name: `${type}.${it}`, program: `print(${VALUES[type] ?? ''}.${it}("a"))` }));
  });
  const modules = boardModules.filter(({ boards: only }) => only?.some((id) => id === tried.type.id) !== false);
  const ofModules = modules.flatMap((module) => {
    const imported = `import ${module.name}`;
    const here = known(module.names, tried);
    const inner = Object.entries(module.names).filter(
      ([name, { members, kind }]) =>
        here.has(name) && kind !== 'exception' && !(name in VALUES) && Object.keys(members).length > 0,
    );
    const objects = [
      { path: module.name, here },
      ...inner.map(([name, { members, bases }]) => ({
        path: `${module.name}.${name}`,
        here: known(
          bases.reduce<Names>((all, base) => ({ ...all, ...builtins[base]?.members }), members),
          tried,
        ),
      })),
    ];
    const all = listed(
      objects.map(({ path }) => path),
      imported,
      tried,
    );
    return objects.flatMap(({ path, here: names }, index) =>
      (all[index] ?? [])
        .filter((it) => !names.has(it))
        .map((it) => ({
          name: `${path}.${it}`,
          program: path === 'builtins' ? `print(${it})` : `${imported}\nprint(${path}.${it})`,
        })),
    );
  });
  return [...ofTypes, ...ofModules];
}

describe.each(boards)('names on the $name', (board) => {
  it('are marked if our VM alone has them', () => {
    const device = { features: board.firmware.features, micropython: board.firmware.micropython };
    const extras = extrasOf(board).filter(({ name }) => !UNLISTED.some(([names]) => names.test(name)));
    const marked = extras.filter(({ program }) => checkForDevice({ 'main.py': program }, device).length > 0);
    expect(extras.filter((it) => !marked.includes(it)).map(({ name }) => name)).toEqual([]);
    expect(marked.length).toBeGreaterThan(25);
  });
});
