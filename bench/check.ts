import { spawn, spawnSync, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Subject } from './subject';

/** Hand-ins of a class. */
const CLASS = 24;

/** Number of hand-ins that warm a thread up, and number of further ones after which its memory is read again. */
const [FIRST, MORE] = [500, 1_500];
/** Each result is kept until the end, a kilobyte or two. */
const MOST_MORE = 1.1;
const MOST_MB = 200;
const LOOK_MS = 250;

/** How long the command line takes for a class. */
export const checkSubject: Subject<undefined> = {
  budgets: [
    { what: `CLI, check of ${CLASS} hand-ins, 20 s of a line follower each`, budget: '<= 3 s' },
    { what: 'CLI, check, hand-ins a second and core once warm', budget: '>= 15' },
  ],
  async measure() {
    const program = readFileSync('courses/closed-line/main.py', 'utf8');
    const secondsOf = async (count: number, jobs: number | 'all'): Promise<number> => {
      const startMs = performance.now();
      const code = await checked(count, program, jobs);
      if (code !== 0) throw new Error(`The check ended with ${code}.`);
      return (performance.now() - startMs) / 1000;
    };
    const classS = await secondsOf(CLASS, 'all');
    // What more hand-ins take on one thread, without its start.
    const perHandIn = ((await secondsOf(4 * CLASS, 1)) - (await secondsOf(CLASS, 1))) / (3 * CLASS);
    return [
      { text: `${classS.toFixed(1)} s`, met: classS <= 3 },
      { text: (1 / perHandIn).toFixed(1), met: perHandIn <= 1 / 15 },
    ];
  },
};

/** Runs of a sweep, and the simulated seconds of each. */
const [RUNS, RUN_S] = [200, 10];

/** How long the command line takes for a sweep. */
export const sweepSubject: Subject<undefined> = {
  budgets: [{ what: `CLI, sweep of ${RUNS} runs of ${RUN_S} s, a line follower, on two threads`, budget: '<= 8 s' }],
  async measure() {
    const vary = `seed=1..${RUNS}/1`;
    const words = ['courses/closed-line/main.py', '--scene', 'closed-line', '--vary', vary, '--for', `${RUN_S}s`];
    const startMs = performance.now();
    const child = spawn(process.execPath, ['dist/cli/main.mjs', 'sweep', ...words, '--jobs', '2', '--quiet']);
    const [code] = (await once(child, 'exit')) as [number];
    if (code !== 0) throw new Error(`The sweep ended with ${code}.`);
    const seconds = (performance.now() - startMs) / 1000;
    return [{ text: `${seconds.toFixed(1)} s`, met: seconds <= 8 }];
  },
};

/** Programs of a tournament. */
const PROGRAMS = 24;

/** How long the command line takes for everyone against everyone: programs that look for the rival, each a little otherwise. */
export const tournamentSubject: Subject<undefined> = {
  budgets: [
    { what: `CLI, tournament of ${PROGRAMS} in sumo, 276 pairs, both sides, on two threads`, budget: '<= 120 s' },
  ],
  async measure() {
    const folder = mkdtempSync(join(tmpdir(), 'parcours-bench-'));
    try {
      const program = readFileSync('courses/sumo/main.py', 'utf8');
      const paths = Array.from({ length: PROGRAMS }, (_, place) => join(folder, `${place}.py`));
      for (const [place, path] of paths.entries())
        writeFileSync(path, program.replace('SEEN = 32', `SEEN = ${20 + 2 * place}`));
      const startMs = performance.now();
      const words = ['tournament', 'sumo', ...paths, '--jobs', '2', '--quiet'];
      const child = spawn(process.execPath, ['dist/cli/main.mjs', ...words]);
      const [code] = (await once(child, 'exit')) as [number];
      if (code !== 0) throw new Error(`The tournament ended with ${code}.`);
      const seconds = (performance.now() - startMs) / 1000;
      return [{ text: `${seconds.toFixed(0)} s`, met: seconds <= 120 }];
    } finally {
      rmSync(folder, { recursive: true });
    }
  },
};

/** True if its memory stays what it is, however many hand-ins there are: programs that end at once, on one thread. */
export const checkMemorySubject: Subject<undefined> = {
  budgets: [
    {
      what: `CLI, memory of a check after ${FIRST} hand-ins and ${MORE.toLocaleString('en')} more`,
      budget: `flat, <= ${MOST_MB} MB`,
    },
  ],
  async measure() {
    const before = await peakMb(FIRST);
    const after = await peakMb(FIRST + MORE);
    const met = after <= MOST_MB && after <= MOST_MORE * before;
    return [{ text: `${before.toFixed(0)} → ${after.toFixed(0)} MB`, met }];
  },
};

async function peakMb(count: number): Promise<number> {
  let most = 0;
  const look = ({ pid }: ChildProcess): void => {
    // It may have ended meanwhile.
    const kB = Number(spawnSync('ps', ['-o', 'rss=', '-p', String(pid)], { encoding: 'utf8' }).stdout);
    if (kB > 0) most = Math.max(most, kB / 1000);
  };
  await checked(count, 'print("here")\n', 1, look);
  if (most === 0) throw new Error('ps says nothing of the memory.');
  return most;
}

/**
 * Checks so many hand-ins on the ready course `closed-line`.
 *
 * @param look called now and then while the process runs
 * @returns its exit code
 */
async function checked(
  count: number,
  program: string,
  jobs: number | 'all',
  look: (child: ChildProcess) => void = () => undefined,
): Promise<number> {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-bench-'));
  try {
    for (let place = 0; place < count; place++) writeFileSync(join(folder, `${place}.py`), `# ${place}\n${program}`);
    const words = ['check', 'closed-line', folder, '--quiet', ...(jobs === 'all' ? [] : ['--jobs', String(jobs)])];
    const child = spawn(process.execPath, ['dist/cli/main.mjs', ...words]);
    const timer = setInterval(() => {
      if (child.exitCode === null) look(child);
    }, LOOK_MS);
    const [code] = (await once(child, 'exit')) as [number];
    clearInterval(timer);
    return code;
  } finally {
    rmSync(folder, { recursive: true });
  }
}
