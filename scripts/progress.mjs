// What the scripts print: titled steps with elapsed time. Node built-ins only: it runs before anything is installed.
import { spawn } from 'node:child_process';
import { realpathSync, writeFileSync } from 'node:fs';
import { constants, setPriority } from 'node:os';
import { fileURLToPath } from 'node:url';

/** The repository's root, with a slash at the end. */
export const root = fileURLToPath(new URL('../', import.meta.url));

/** A duration as people read it: 0.4 s, 12 s, 2 min 5 s. */
export function elapsed(ms) {
  if (ms < 9_950) return `${(ms / 1000).toFixed(1)} s`;
  const seconds = Math.round(ms / 1000);
  return seconds < 60 ? `${seconds} s` : `${Math.floor(seconds / 60)} min ${seconds % 60} s`;
}

/** Prints a line of its own for something that is done at once. */
export function note(text) {
  process.stdout.write(`  ${text}\n`);
}

/** The steps that run now, side by side, and when each began. */
const running = new Map();

/**
 * Runs one step, printing its title before and its time after; on a terminal a running clock meanwhile, one for all steps
 * that run side by side. What the work rejects with is passed on.
 */
export async function step(title, work) {
  const started = Date.now();
  running.set(title, started);
  process.stdout.write(`${leftOfClock()}▸ ${title}\n`);
  const ticker = process.stdout.isTTY
    ? setInterval(() => process.stdout.write(clock(title)), 1000)
    : setInterval(() => note(`… ${title}, ${elapsed(Date.now() - started)} so far`), 30_000);
  try {
    return await work();
  } finally {
    clearInterval(ticker);
    running.delete(title);
    process.stdout.write(leftOfClock());
    note(`${title}: ${elapsed(Date.now() - started)}`);
  }
}

/** The running clock, which the step that has run longest shows for all. */
const clock = (title) =>
  running.keys().next().value === title
    ? `\r  … ${[...running].map(([name, since]) => `${name} ${elapsed(Date.now() - since)}`).join(', ')} `
    : '';

/** On a terminal the next line is written over the running clock. */
const leftOfClock = () => (process.stdout.isTTY ? '\r\x1b[K' : '');

/**
 * Runs a program in the repository's root.
 *
 * @param {string} command a program, or `node` for the Node that runs this script
 * @param {readonly string[]} args
 * @param {{ env?: Record<string, string | undefined>, quiet?: boolean, input?: Promise<string>, givesWay?: boolean }} [options]
 *   quiet: collect the output instead of showing it; input: what the program reads, once it is known; nothing if that fails;
 *   givesWay: it gets the processor only while nothing else wants it
 * @returns {Promise<{ code: number, output: string }>} the exit code (1 when it could not start) and the collected output
 */
export function run(command, args, { env = {}, quiet = false, input, givesWay = false } = {}) {
  const { program, leading, shell } = programFor(command);
  return new Promise((resolve) => {
    let output = '';
    const child = spawn(program, [...leading, ...args], {
      cwd: root,
      env: { ...process.env, ...(process.stdout.isTTY ? {} : { NO_COLOR: '1' }), ...env },
      shell,
      stdio: [input ? 'pipe' : 'ignore', quiet ? 'pipe' : 'inherit', quiet ? 'pipe' : 'inherit'],
      detached: givesWay && process.platform === 'linux',
    });
    if (givesWay) giveWay(child);
    child.stdin?.on('error', () => {}); // it has ended without reading
    input?.then(
      (text) => child.stdin?.end(text),
      () => child.stdin?.end(),
    );
    child.stdout?.on('data', (chunk) => (output += chunk));
    child.stderr?.on('data', (chunk) => (output += chunk));
    child.on('error', (error) => resolve({ code: 1, output: `${output}${error.message}\n` }));
    child.on('close', (code) => resolve({ code: code ?? 1, output }));
  });
}

/**
 * Puts a program behind all others. Linux shares the time between sessions first (autogroups), so there the program has one
 * of its own, which a Ctrl-C does not reach by itself.
 */
function giveWay(child) {
  try {
    setPriority(child.pid, constants.priority.PRIORITY_LOW);
    if (process.platform === 'linux') writeFileSync(`/proc/${child.pid}/autogroup`, '19');
  } catch {
    // It has not started, or the system knows no such thing: then it takes its share.
  }
  for (const signal of /** @type {const} */ (['SIGINT', 'SIGTERM'])) {
    const end = () => {
      child.kill();
      process.kill(process.pid, signal); // nobody listens any more: it ends as it would have
    };
    process.once(signal, end);
    child.once('close', () => process.off(signal, end));
  }
}

/** Like `run`, but a failure ends the step with the program's own words. */
export async function mustRun(command, args, options = {}) {
  const { code, output } = await run(command, args, options);
  if (code !== 0) throw new Failure(`${command} ${args.join(' ')} failed (exit code ${code}).\n${output}`.trimEnd());
}

/** A failure that was explained to the reader: shown without a stack. */
export class Failure extends Error {}

/** Runs a script's main function when the script was started directly; a failure sets the exit code. */
export async function main(moduleUrl, work) {
  if (!process.argv[1] || realpathSync(process.argv[1]) !== fileURLToPath(moduleUrl)) return;
  try {
    await work(process.argv.slice(2));
  } catch (error) {
    process.stderr.write(`\n${error instanceof Failure ? error.message : (error?.stack ?? error)}\n`);
    process.exitCode = 1;
  }
}

function programFor(command) {
  if (command === 'node') return { program: process.execPath, leading: [], shell: false };
  const npm = process.env.npm_execpath ?? ''; // the npm that started us
  if (command === 'npm' && npm.endsWith('npm-cli.js'))
    return { program: process.execPath, leading: [npm], shell: false };
  return { program: command, leading: [], shell: command === 'npm' && process.platform === 'win32' }; // a batch file there
}
