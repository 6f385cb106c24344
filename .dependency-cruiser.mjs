import { layers, webLayers } from './layers.mjs';

/** Tests may use Node and stand beside what they test; build code of the VM runs in Node only. */
/** Programs for real boards; the command line runs them, too. */
const PROBES = '^docs/hardware/probe/.*\\.py$';
const TEST = '\\.test\\.ts$|/testing/';
const BUILD = '^src/vm/firmware/';
/** Made by set-up, so it need not be there yet. */
const MADE = '\\.cache/vm/';
/** Its package names a file of types that is not there. */
const MISTYPED = '^@microbit/microbit-fs$';

/**
 * One rule per room below `root`: whatever is not listed in its row of layers.mjs is forbidden. Tests may reach further: a
 * robot's library is tested by running it on the VM.
 */
const rowsAsRules = (table, root, prefix) =>
  Object.entries(table).map(([room, allowed]) => ({
    name: `${prefix}-${room}`,
    comment: `${room} may import ${allowed.join(', ') || 'nothing'} (layers.mjs)`,
    severity: 'error',
    from: { path: `^${root}/${room}/`, pathNot: TEST },
    to: { path: `^${root}/[^/]+/`, pathNot: [room, ...allowed].map((name) => `^${root}/${name}/`) },
  }));

/** Every folder below `root` is a room of the table. */
const onlyRooms = (table, root, name) => ({
  name,
  comment: `Every folder of ${root}/ needs a row in layers.mjs.`,
  severity: 'error',
  from: {},
  to: { path: `^${root}/[^/]+/`, pathNot: `^${root}/(${Object.keys(table).join('|')})/` },
});

const onlyIn = (name, packages, home, comment) => ({
  name,
  comment,
  severity: 'error',
  from: { path: '^src/', pathNot: home },
  to: { path: packages.map((it) => `(^|/)node_modules/${it}(/|$)`) },
});

export default {
  forbidden: [
    ...rowsAsRules(layers, 'src', 'layer'),
    ...rowsAsRules(webLayers, 'src/web', 'web-layer'),
    onlyRooms(layers, 'src', 'unknown-room'),
    onlyRooms(webLayers, 'src/web', 'unknown-room-of-the-page'),
    {
      name: 'no-cycles',
      comment: 'A circle between files.',
      severity: 'error',
      from: { path: '^src/' },
      to: { circular: true },
    },
    {
      name: 'rooms-by-name',
      comment: 'Other rooms are imported as #room/…, never by a relative path.',
      severity: 'error',
      from: { path: '^src/([^/]+)/' },
      to: { path: '^src/[^/]+/', pathNot: '^src/$1/', dependencyTypesNot: ['aliased-subpath-import'] },
    },
    {
      name: 'robots-apart',
      comment: 'Robots do not know each other.',
      severity: 'error',
      from: { path: '^src/robots/([^/]+)/' },
      to: { path: '^src/robots/[^/]+/', pathNot: ['^src/robots/$1/', '^src/robots/testing/'] },
    },
    {
      name: 'tests-are-leaves',
      comment: 'Nothing but tests imports tests and test benches.',
      severity: 'error',
      from: { path: '^src/', pathNot: TEST },
      to: { path: TEST },
    },
    {
      name: 'outside-src',
      comment:
        'Code in src/ reaches nothing outside it but packages, the ready courses (web, cli and tests) and the probes (cli).',
      severity: 'error',
      from: { path: '^src/', pathNot: [TEST, BUILD] },
      to: {
        pathNot: ['^src/', '(^|/)node_modules/', '^courses/', PROBES, '^package\\.json$', MADE],
        dependencyTypesNot: ['core'],
        couldNotResolve: false,
      },
    },
    {
      name: 'probes-in-cli',
      comment: 'The probes are for the command line alone.',
      severity: 'error',
      from: { path: '^src/', pathNot: ['^src/cli/', TEST] },
      to: { path: PROBES },
    },
    {
      name: 'courses-in-web-and-cli',
      comment: 'Ready courses are data for the app, the command line and tests.',
      severity: 'error',
      from: { path: '^src/', pathNot: ['^src/(web|cli)/', TEST] },
      to: { path: '^courses/' },
    },
    {
      name: 'node-in-cli',
      comment: 'Node built-ins only in cli, tests and build code.',
      severity: 'error',
      from: { path: '^src/', pathNot: ['^src/cli/', TEST, BUILD] },
      to: { dependencyTypes: ['core'] },
    },
    onlyIn('engine-in-physics', ['planck'], '^src/world/physics/', 'The physics engine only in world/physics.'),
    onlyIn('micropython-in-vm', ['@micropython'], '^src/vm/', 'MicroPython only in vm.'),
    onlyIn(
      'drawing-in-web',
      ['vue', '@vue', 'codemirror', '@codemirror', '@lezer/highlight', '@lezer/lr'],
      '^src/web/',
      'Vue and the code editor only in web.',
    ),
    onlyIn(
      'hexes-in-hex',
      ['nrf-intel-hex', '@microbit/microbit-fs', '@microbit/microbit-universal-hex'],
      '^src/hex/',
      'What writes hexes only in hex.',
    ),
    onlyIn('icons-in-pictures', ['@mdi'], '^src/(web|picture)/', 'Icons (plain texts) only in web and in the picture.'),
    onlyIn(
      'parser-in-python',
      ['@lezer/python', '@lezer/common'],
      '^src/(web|python)/',
      "The editor's Python parser (plain JavaScript) only in web and in the room that reads programs.",
    ),
    {
      name: 'not-found',
      comment: 'The import leads nowhere.',
      severity: 'error',
      from: { path: '^src/' },
      to: { couldNotResolve: true, pathNot: ['^virtual:', '^single:', '^w3c-web-serial$', MISTYPED, MADE] },
    },
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    exclude: { path: '^(dist|\\.cache)/' },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.web.json' },
    enhancedResolveOptions: {
      exportsFields: ['exports'],
      conditionNames: ['import', 'module', 'browser', 'default', 'types'],
      extensions: ['.ts', '.vue', '.mjs', '.js', '.json', '.d.ts'],
    },
  },
};
