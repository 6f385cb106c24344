// npm run example NAME: runs one of the small programs for developers in examples/dev; without a name it lists them.
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { runnerImport } from 'vite';
import { Failure, main, root } from './progress.mjs';

const FOLDER = 'examples/dev';
const names = () =>
  readdirSync(join(root, FOLDER)).flatMap((file) => (/^(?!examples?\b).*\.ts$/.test(file) ? [file.slice(0, -3)] : []));

await main(import.meta.url, async ([name]) => {
  if (name === undefined) {
    console.log(names().join('\n'));
    return;
  }
  const path = `${FOLDER}/${name}.ts`;
  if (!existsSync(join(root, path)))
    throw new Failure(`There is no example ${name}. There are: ${names().join(', ')}.`);
  const options = { root, configFile: /** @type {const} */ (false), logLevel: /** @type {const} */ ('error') };
  const { words } = /** @type {any} */ ((await runnerImport(join(root, 'build/words.ts'), options)).module);
  const { module } = await runnerImport(join(root, path), { ...options, plugins: [words()] });
  await /** @type {any} */ (module).main(console.log);
});
