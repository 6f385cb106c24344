import prettier from 'eslint-config-prettier/flat';
import vue from 'eslint-plugin-vue';
import tseslint from 'typescript-eslint';
import { layers } from './layers.mjs';
import { classLines } from './scripts/class-lines.mjs';
import { docstringWords } from './scripts/docstring-words.mjs';
import { moduleState } from './scripts/module-state.mjs';

/** The rooms where the same run must come out everywhere: all but those that meet the outside. */
const outside = ['cli', 'web', 'embed'];
const pureRooms = Object.keys(layers)
  .filter((room) => !outside.includes(room))
  .map((room) => `src/${room}/**/*.ts`);
const tests = [
  'src/**/*.test.ts',
  'examples/dev/*.test.ts',
  'build/**/*.test.ts',
  'src/**/testing/**/*.ts',
  'e2e/**/*.ts',
  'scripts/**/*.test.mjs',
  'examples/**/*.test.mjs',
];
const buildCode = ['src/vm/firmware/**'];
const inNode = [
  'scripts/**/*.mjs',
  'bin/**/*.mjs',
  '*.mjs',
  'src/vm/firmware/**/*.mjs',
  'e2e/**/*.mjs',
  'examples/**/*.mjs',
];

const own = 'See CONTRIBUTING.md, "The same run everywhere".';
const clocks = ['Date', 'performance', 'setTimeout', 'setInterval', 'setImmediate', 'clearTimeout', 'clearInterval'];
const surroundings = ['requestAnimationFrame', 'window', 'document', 'navigator', 'process', 'fetch', 'crypto', 'Intl'];
const exactInstead = [
  'sin',
  'cos',
  'tan',
  'asin',
  'acos',
  'atan',
  'atan2',
  'sinh',
  'cosh',
  'tanh',
  'asinh',
  'acosh',
].concat(['atanh', 'exp', 'expm1', 'log', 'log1p', 'log2', 'log10', 'pow', 'hypot', 'cbrt']);

const sameness = {
  'no-restricted-globals': [
    'error',
    ...clocks.map((name) => ({ name, message: `Simulated time comes from Clock in #core/clock. ${own}` })),
    ...surroundings.map((name) => ({ name, message: `Rooms of the simulation know neither page nor system. ${own}` })),
  ],
  'no-restricted-properties': [
    'error',
    { object: 'Math', property: 'random', message: `Draw from the run's Rng (#core/rng). ${own}` },
    ...exactInstead.map((property) => ({
      object: 'Math',
      property,
      message: `Math.${property} differs between engines; use #core/exact-math. ${own}`,
    })),
    { property: 'toLocaleString', message: `Depends on the machine's language. ${own}` },
    { property: 'localeCompare', message: `Depends on the machine's language. ${own}` },
  ],
  'no-restricted-syntax': [
    'error',
    ...["BinaryExpression[operator='**']", "AssignmentExpression[operator='**=']"].map((selector) => ({
      selector,
      message: `** differs between engines; multiply, shift or use #core/exact-math. ${own}`,
    })),
  ],
};

/** Imports allowed in only one place; dependency-cruiser checks the same, this does it while typing. */
const foreign = (...patterns) => ({ 'no-restricted-imports': ['error', { patterns }] });
const planck = { group: ['planck', 'planck/*'], message: 'The physics engine only in src/world/physics.' };
const drawing = {
  group: ['vue', 'codemirror', '@codemirror/*', '@lezer/*', '@mdi/js'],
  message: 'Vue and the code editor only in src/web.',
};
/** Parts of the editor that the room for reading programs may use. */
const parser = ['!@lezer/python', '!@lezer/common'];
const node = { group: ['node:*'], message: 'Node only in cli, tests and build code.' };

const sizes = {
  'max-lines': ['error', 400],
  'max-lines-per-function': ['error', 60],
  'parcours/class-lines': ['error', 250],
};

export default tseslint.config(
  {
    ignores: [
      'dist/',
      '.cache/',
      'coverage/',
      'test-results/',
      'playwright-report/',
      'examples/hosts/*/public/',
      'src/**/words/**/index.d.ts',
    ],
  },
  { linterOptions: { reportUnusedDisableDirectives: 'error' } },
  {
    plugins: { parcours: { rules: { 'class-lines': classLines, 'docstring-words': docstringWords } } },
    rules: {
      ...sizes,
      'parcours/docstring-words': 'error',
      eqeqeq: 'error',
      'no-console': 'error',
      'no-warning-comments': ['error', { terms: ['todo', 'fixme', 'xxx'] }],
      'object-shorthand': 'error',
      'prefer-const': 'error',
      'no-var': 'error',
      'no-restricted-exports': ['error', { restrictDefaultExports: { direct: true, named: true } }],
    },
  },

  // TypeScript: the strict set, with type information.
  {
    files: ['src/**/*.ts', 'e2e/**/*.ts', 'bench/**/*.ts', 'examples/dev/*.ts', 'build/**/*.ts', '*.config.ts'],
    extends: [tseslint.configs.strictTypeChecked],
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    rules: {
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true, allowBoolean: true }],
      '@typescript-eslint/no-confusing-void-expression': [
        'error',
        { ignoreArrowShorthand: true, ignoreVoidReturningFunctions: true },
      ],
      '@typescript-eslint/no-unnecessary-condition': 'off', // does not see that a call may change what was just checked
      '@typescript-eslint/no-unused-vars': [
        'error',
        { argsIgnorePattern: '^_', caughtErrors: 'none', ignoreRestSiblings: true },
      ],
      '@typescript-eslint/switch-exhaustiveness-check': ['error', { considerDefaultExhaustiveForUnions: true }],
      '@typescript-eslint/no-empty-function': 'off',
      '@typescript-eslint/no-extraneous-class': 'off',
    },
  },

  // Vue components: the compiler (vue-tsc) checks their types, ESLint their form.
  {
    files: ['src/**/*.vue'],
    extends: [tseslint.configs.strict, vue.configs['flat/recommended']],
    languageOptions: { parserOptions: { parser: tseslint.parser } },
    rules: {
      'max-lines': ['error', 300],
      'no-undef': 'off',
      'vue/v-bind-style': ['error', 'shorthand', { sameNameShorthand: 'always' }],
      'vue/block-lang': ['error', { script: { lang: 'ts' } }],
      'vue/block-order': ['error', { order: ['script', 'template', 'style'] }],
      'vue/component-api-style': ['error', ['script-setup']],
      'vue/multi-word-component-names': 'off',
      'vue/require-default-prop': 'off',
      'vue/no-v-html': 'error',
    },
  },
  { files: ['src/web/**/*.ts'], rules: { '@typescript-eslint/no-unsafe-argument': 'off' } }, // components are opaque here
  {
    // What a mounted component shows is opaque, too; vue-tsc checks its types.
    files: ['src/web/**/*.test.ts'],
    rules: {
      '@typescript-eslint/no-unsafe-call': 'off',
      '@typescript-eslint/no-unsafe-member-access': 'off',
      '@typescript-eslint/no-unsafe-return': 'off',
    },
  },

  // Who may import what.
  { files: ['src/**/*.{ts,vue}'], rules: foreign(planck, drawing, node) },
  { files: ['src/world/physics/**/*.ts'], rules: foreign(drawing, node) },
  { files: ['src/cli/**/*.ts'], rules: foreign(planck, drawing) },
  { files: ['src/web/**/*.{ts,vue}'], rules: foreign(planck, node) },
  // Icons are plain texts.
  {
    files: ['src/picture/**/*.ts'],
    rules: foreign(planck, { ...drawing, group: [...drawing.group, '!@mdi/js'] }, node),
  },
  // The editor's own Python parser reads the program here too: plain JavaScript that knows no page.
  {
    files: ['src/python/**/*.ts'],
    rules: foreign(planck, { ...drawing, group: [...drawing.group, ...parser] }, node),
  },

  // The same run everywhere.
  { files: pureRooms, ignores: [...tests, ...buildCode], rules: sameness },

  // A page that is closed leaves nothing behind.
  {
    files: ['src/web/**/*.ts'],
    ignores: [
      ...tests,
      // Workers are one model each.
      'src/web/session/run/worker/**',
      // Of the window, whatever pages it has: its language, its frames, what lies over it, and messages before its page.
      'src/web/kit/i18n/index.ts',
      'src/web/kit/drawing/frame-gate.ts',
      'src/web/kit/overlays/overlays.ts',
      'src/web/kit/bar/page-bar.ts',
      'src/web/exchange/host/listen-to-host.ts',
    ],
    rules: { 'no-restricted-syntax': ['error', ...moduleState] },
  },

  // planck's types mark its classes' call signatures as deprecated, and with them every mention of a class.
  { files: ['src/world/physics/**/*.ts'], rules: { '@typescript-eslint/no-deprecated': 'off' } },
  // The one place that puts exact functions in the place of the engine's while planck loads.
  { files: ['src/world/physics/*-exact-trig.ts'], rules: { 'no-restricted-properties': 'off' } },

  // Read by the oldest of browsers.
  { files: ['src/web/app/frame-check/*.js'], rules: { 'no-var': 'off' } },

  // Tests and what runs in Node only.
  {
    files: tests,
    rules: {
      'max-lines': ['error', 800],
      'max-lines-per-function': 'off',
      'no-restricted-imports': 'off',
      '@typescript-eslint/no-non-null-assertion': 'off',
      '@typescript-eslint/no-unsafe-assignment': 'off', // expect.closeTo() and the like are any
    },
  },
  { files: inNode, rules: { 'no-console': 'off' } },
  { files: ['src/cli/**', 'bench/**'], rules: { 'no-console': 'off' } },
  {
    files: [
      '*.config.{ts,mjs}',
      '.dependency-cruiser.mjs',
      '{e2e,examples}/**/*.config.{ts,js}',
      'src/**/*.vue',
      'src/**/*.d.ts',
    ],
    rules: { 'no-restricted-exports': 'off' },
  },

  // Tables: long because there is much of it, not because it is tangled.
  {
    files: ['src/**/*-table.ts', 'src/**/*.table.ts'],
    rules: { 'max-lines': 'off', 'max-lines-per-function': 'off' },
  },
  prettier,
);
