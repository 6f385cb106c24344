// Checks who imports whom (layers.mjs), that no folders of the page import each other in a circle, that no folder is crowded,
// and that the graphs in docs/architecture.md are what the code says; `--write` renews them.
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, posix } from 'node:path';
import { cruise } from 'dependency-cruiser';
import configuration from '../.dependency-cruiser.mjs';
import { layers, webLayers, wings } from '../layers.mjs';
import { Failure, main, note, root } from './progress.mjs';

const DOCUMENT = 'docs/architecture.md';
/** Most source files in one folder: more than a newcomer takes in at a glance. Chosen. */
const CROWDED = 30;
/** The rooms that show and ask, and in them the threads that they start, with their own files. */
const SHOWS = /^src\/(web|cli)\//;
const RUNS = /^src\/web\/session\/run\/worker\/|^src\/cli\/(\w+\/)?([\w-]+-)?worker\.ts$/;
const SIMULATION = 'src/simulation/simulation.ts';
const isTest = (path) => /\.test\.ts$|\/testing\//.test(path);
const isCode = (path) => /\.(ts|vue|css)$/.test(path);

/** The graphs of the document: which folder's rooms, in which order, and the rooms that every other may import. */
const GRAPHS = [
  { mark: 'graph', folder: 'src', table: layers, floor: 'core' },
  { mark: 'web-graph', folder: 'src/web', table: wings, floor: 'kit' },
];

/** The imports between files as pairs, without tests. */
export const importsOf = (modules) =>
  modules.flatMap(({ source, dependencies }) =>
    isTest(source) ? [] : dependencies.map(({ resolved }) => [source, resolved]),
  );

/**
 * The stylesheets that a component or a stylesheet takes in, as imports: `<style src>` and `@import`. The cruiser sees only what
 * scripts import.
 *
 * @param {string} path of the file below the root, with `/`
 * @param {string} text what is in it
 * @returns {[from: string, to: string][]}
 */
export function styleImportsIn(path, text) {
  const found = text.matchAll(/<style\b[^>]*\ssrc="([^"]+)"|@import\s+(?:url\()?["']?([^"')\s;]+)/g);
  return Array.from(found, ([, source, imported]) => posix.join(posix.dirname(path), source ?? imported))
    .filter((to) => to.endsWith('.css'))
    .map((to) => [path, to]);
}

/** The room of a table that a file below `folder` is in; `undefined`: in none. */
const roomIn = (path, { folder, table }) => Object.keys(table).find((room) => path.startsWith(`${folder}/${room}/`));

/** Imports between rooms of a table that it does not allow, each with its sentence. */
export const forbiddenBetween = (imports, { folder, table }) =>
  imports.flatMap(([from, to]) => {
    const room = roomIn(from, { folder, table });
    const reached = room === undefined ? [] : [room, ...table[room]];
    if (room === undefined || !to.startsWith(`${folder}/`)) return [];
    if (reached.some((name) => to.startsWith(`${folder}/${name}/`))) return [];
    return [`${from} → ${to}\n    ${room} may import ${table[room].join(', ') || 'nothing'} (layers.mjs)`];
  });

/** Mermaid text of the imports between the rooms below a folder as they are; the floor, which every room may import, is left out. */
export function graphOf(imports, { folder, table, floor }) {
  const roomOf = (path) =>
    path.startsWith(`${folder}/`) ? /^([^/]+)\//.exec(path.slice(folder.length + 1))?.[1] : undefined;
  const edges = new Set();
  for (const [source, resolved] of imports) {
    const [from, to] = [roomOf(source), roomOf(resolved)];
    if (from && to && from !== to && to !== floor) edges.add(`  ${from} --> ${to}`);
  }
  const order = (edge) => Object.keys(table).indexOf(edge.trim().split(' ')[0]);
  const lines = [...edges].sort((a, b) => order(a) - order(b) || (a < b ? -1 : 1));
  return ['```mermaid', 'flowchart TD', ...lines, '```', ''].join('\n');
}

/** Folders below `within` that import each other in a circle, each circle as the list of its folders. */
export function folderCircles(imports, within) {
  const next = new Map();
  for (const [source, resolved] of imports) {
    const [from, to] = [dirname(source), dirname(resolved)];
    if (from === to || !isCode(resolved) || ![from, to].every((it) => it.startsWith(within))) continue;
    next.set(from, (next.get(from) ?? new Set()).add(to));
  }
  const reached = (from) => {
    const seen = new Set();
    const waiting = [...(next.get(from) ?? [])];
    for (let at = waiting.pop(); at !== undefined; at = waiting.pop()) {
      if (seen.has(at)) continue;
      seen.add(at);
      waiting.push(...(next.get(at) ?? []));
    }
    return seen;
  };
  const reach = new Map([...next.keys()].map((folder) => [folder, reached(folder)]));
  const circles = [...reach].flatMap(([folder, seen]) =>
    seen.has(folder)
      ? [
          [...seen]
            .filter((it) => reach.get(it)?.has(folder))
            .sort()
            .join(' ↔ '),
        ]
      : [],
  );
  return [...new Set(circles)];
}

/** Folders of src/ with more than `CROWDED` source files. */
async function crowdedFolders() {
  const entries = await readdir(join(root, 'src'), { recursive: true, withFileTypes: true });
  const counts = new Map();
  for (const entry of entries) {
    const folder = join(entry.parentPath ?? entry.path)
      .slice(root.length)
      .replace(/^\//, '')
      .replaceAll('\\', '/');
    if (!entry.isFile() || !/\.(ts|vue|css|mjs|py)$/.test(entry.name) || isTest(`${folder}/${entry.name}`)) continue;
    counts.set(folder, (counts.get(folder) ?? 0) + 1);
  }
  return [...counts].flatMap(([folder, count]) => (count > CROWDED ? [`${folder}: ${count} source files`] : []));
}

/** All stylesheets that are taken in below src/. */
async function styleImports() {
  const names = await readdir(join(root, 'src'), { recursive: true });
  const paths = names.map((name) => `src/${name.replaceAll('\\', '/')}`).filter((path) => /\.(vue|css)$/.test(path));
  const found = await Promise.all(
    paths.map(async (path) => styleImportsIn(path, await readFile(join(root, path), 'utf8'))),
  );
  return found.flat();
}

async function cruiseSources() {
  const { options, forbidden } = configuration;
  const { output } = await cruise(
    ['src'],
    { ...options, ruleSet: /** @type {any} */ ({ forbidden }), validate: true },
    options.enhancedResolveOptions,
  );
  if (typeof output === 'string') throw new Error(output); // only with an outputType
  return output;
}

function complain(violations, styles) {
  const lines = violations.map(({ from, to, rule, cycle }) => {
    const way = cycle ? cycle.map(({ name }) => name).join(' → ') : to;
    const why = configuration.forbidden.find(({ name }) => name === rule.name)?.comment ?? '';
    return `${from} → ${way}\n    ${rule.name}: ${why}`;
  });
  lines.push(...forbiddenBetween(styles, { folder: 'src/web', table: webLayers }));
  if (lines.length > 0) throw new Failure(`${lines.length} forbidden imports:\n${lines.join('\n')}`);
}

/**
 * The ways of imports to a file, types apart, what is fetched later included.
 *
 * @returns {Map<string, string[]>} by the file in which a way begins: the files on the shortest one, both ends included
 */
export function waysTo(goal, modules) {
  const importers = new Map();
  for (const { source, dependencies } of modules)
    for (const { resolved, dependencyTypes = [] } of dependencies)
      if (!dependencyTypes.includes('type-only') && !isTest(source))
        importers.set(resolved, [...(importers.get(resolved) ?? []), source]);
  const ways = new Map([[goal, [goal]]]);
  for (const [path, way] of ways)
    for (const source of importers.get(path) ?? []) if (!ways.has(source)) ways.set(source, [source, ...way]);
  return ways;
}

/** Complains where the page or the command line would load the simulation outside the threads that run it. */
function checkThreads(modules) {
  const ways = [...waysTo(SIMULATION, modules)].filter(([path]) => SHOWS.test(path) && !RUNS.test(path));
  if (ways.length === 0) return;
  const lines = ways.map(([, way]) => way.join(' → '));
  throw new Failure(`Would load the simulation, which only threads run:\n${lines.join('\n')}`);
}

/** Complains about folders that nobody finds their way in. */
async function checkFolders(imports) {
  const circles = folderCircles(imports, 'src/web');
  if (circles.length > 0) throw new Failure(`Folders that import each other:\n${circles.join('\n')}`);
  const crowded = await crowdedFolders();
  if (crowded.length > 0) throw new Failure(`More than ${CROWDED} source files in one folder:\n${crowded.join('\n')}`);
}

const withGraphs = (document, imports) =>
  GRAPHS.reduce((text, graph) => {
    const marked = new RegExp(`(<!-- ${graph.mark}:start[^>]*-->\\n)[\\s\\S]*?(<!-- ${graph.mark}:end -->)`);
    return text.replace(marked, (_, start, end) => `${start}\n${graphOf(imports, graph)}\n${end}`);
  }, document);

await main(import.meta.url, async ([option]) => {
  const { modules, summary } = await cruiseSources();
  const styles = await styleImports();
  const imports = [...importsOf(modules), ...styles];
  const place = join(root, DOCUMENT);
  const before = await readFile(place, 'utf8');
  const after = withGraphs(before, imports);
  if (option === '--write') await writeFile(place, after);
  complain(summary.violations, styles);
  checkThreads(modules);
  await checkFolders(imports);
  if (option !== '--write' && after !== before) throw new Failure(`The graphs in ${DOCUMENT} are stale: npm run graph`);
  note(`${modules.length} modules, no forbidden import, no circle between folders of the page.`);
});
