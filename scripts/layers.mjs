// Checks who imports whom (layers.mjs) and that the graph in docs/architecture.md is what the code says; `--write` renews it.
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { cruise } from 'dependency-cruiser';
import configuration from '../.dependency-cruiser.mjs';
import { layers } from '../layers.mjs';
import { Failure, main, note, root } from './progress.mjs';

const DOCUMENT = 'docs/architecture.md';
const MARKED = /(<!-- graph:start[^>]*-->\n)[\s\S]*?(<!-- graph:end -->)/;

const roomOf = (path) => /^src\/([^/]+)\//.exec(path)?.[1];

/** Mermaid text of the imports between rooms as they are; tests left out, and core, which every room may import. */
export function graphOf(modules) {
  const edges = new Set();
  for (const { source, dependencies } of modules) {
    if (/\.test\.ts$|\/testing\//.test(source)) continue;
    for (const { resolved } of dependencies) {
      const [from, to] = [roomOf(source), roomOf(resolved)];
      if (from && to && from !== to && to !== 'core') edges.add(`  ${from} --> ${to}`);
    }
  }
  const order = (edge) => Object.keys(layers).indexOf(edge.trim().split(' ')[0]);
  const lines = [...edges].sort((a, b) => order(a) - order(b) || (a < b ? -1 : 1));
  return ['```mermaid', 'flowchart TD', ...lines, '```', ''].join('\n');
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

function complain(violations) {
  const lines = violations.map(({ from, to, rule, cycle }) => {
    const way = cycle ? cycle.map(({ name }) => name).join(' → ') : to;
    const why = configuration.forbidden.find(({ name }) => name === rule.name)?.comment ?? '';
    return `${from} → ${way}\n    ${rule.name}: ${why}`;
  });
  if (lines.length > 0) throw new Failure(`${lines.length} forbidden imports:\n${lines.join('\n')}`);
}

await main(import.meta.url, async ([option]) => {
  const { modules, summary } = await cruiseSources();
  const place = join(root, DOCUMENT);
  const before = await readFile(place, 'utf8');
  const after = before.replace(MARKED, (_, start, end) => `${start}\n${graphOf(modules)}\n${end}`);
  if (option === '--write') await writeFile(place, after);
  complain(summary.violations);
  if (option !== '--write' && after !== before) throw new Failure(`The graph in ${DOCUMENT} is stale: npm run graph`);
  note(`${modules.length} modules, no forbidden import.`);
});
