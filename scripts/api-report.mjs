// npm run api: writes what the packages export, types alone, to packages/API.md. packages.test.mjs compares: a change of it is
// a change for hosts, which decides the next version and belongs into the changes of the protocol (docs/embedding.md).
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { bundleTypes } from './bundle-types.mjs';
import { packages } from './packages.mjs';
import { main, note, root } from './progress.mjs';

export const API_REPORT = join(root, 'packages/API.md');

const HEAD = `# API of the packages

Written by \`npm run api\`. What a package exports, and the types that it consists of; what an earlier package shows is not
shown again.
`;

/** The declarations of a module's exports, without comments. */
const declarationsOf = (entry) =>
  bundleTypes(join(root, entry))
    .replace(/^[ \t]*\/\*[^]*?\*\/\n?/gm, '')
    .split(/\n{2,}/)
    .map((text) => text.trim());

/** The report: a chapter for each package, each declaration once. */
export function apiReport() {
  const shown = new Set();
  const chapters = packages.map(({ folder, entry }) => {
    const own = declarationsOf(entry).filter((text) => !shown.has(text));
    own.forEach((text) => shown.add(text));
    return `## parcours-${folder}\n\n\`\`\`ts\n${own.join('\n\n')}\n\`\`\`\n`;
  });
  return [HEAD, ...chapters].join('\n');
}

await main(import.meta.url, async () => {
  await writeFile(API_REPORT, apiReport());
  note('packages/API.md is up to date.');
});
