import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';

/** The folder of what is made once; `npm run e2e` empties it. */
const FOLDER = '.cache/once-a-run';

type Outcome<T> = { readonly made: T } | { readonly problem: string };

/**
 * Makes something once for all engines and test workers of a run: the first who asks makes it, the others wait.
 *
 * @param name of its folder
 * @param make gets the folder, which is empty; JSON must be able to hold what it returns
 * @throws Error with the problem of the one who has made it
 */
export async function onceARun<T>(name: string, make: (folder: string) => Promise<T>): Promise<T> {
  await mkdir(FOLDER, { recursive: true });
  const folder = resolve(FOLDER, name);
  const told = join(folder, 'made.json');
  if (await isFirst(folder)) {
    const outcome: Outcome<T> = await make(folder).then(
      (made) => ({ made }),
      (error: unknown) => ({ problem: String(error) }),
    );
    await writeFile(`${told}.new`, JSON.stringify(outcome));
    await rename(`${told}.new`, told); // at once: nobody reads half of it
  }
  const outcome = JSON.parse(await whenThere(told)) as Outcome<T>;
  if ('problem' in outcome) throw new Error(`${name} could not be made: ${outcome.problem}`);
  return outcome.made;
}

const isFirst = (folder: string): Promise<boolean> =>
  mkdir(folder).then(
    () => true,
    () => false,
  );

/** The text of a file, once it is there. A test's own time limit ends the waiting. */
async function whenThere(path: string): Promise<string> {
  for (;;) {
    const text = await readFile(path, 'utf8').catch(() => null);
    if (text !== null) return text;
    await sleep(100);
  }
}
