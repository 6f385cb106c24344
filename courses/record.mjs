// npm run courses:record: drives every course and writes down how it went: golden.json (exact) and expected.csv (for people
// and for tests with a tolerance). A new recording needs a reason in its commit. With names of courses behind it, only those.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const MAX_ROWS = 190;
const TOLERANCE = '# tolerance: x_mm 10, y_mm 10, heading_deg 5';

const only = process.argv.slice(2);
const golden = JSON.parse(readFileSync(here('golden.json'), 'utf8'));
const scratch = mkdtempSync(join(tmpdir(), 'parcours-'));
try {
  for (const run of golden.runs) if (only.length === 0 || only.includes(run.folder)) record(run);
} finally {
  rmSync(scratch, { recursive: true });
}
writeFileSync(here('golden.json'), `${JSON.stringify(golden, null, 2)}\n`);

function record(run) {
  const trace = join(scratch, 'trace.csv');
  const files = [here(`${run.folder}/main.py`), '--scene', here(`${run.folder}/scene.json`)];
  const args = [
    'run',
    ...files,
    '--for',
    `${run.forMs}ms`,
    '--seed',
    String(run.seed),
    '--trace',
    trace,
    '--json',
    '--quiet',
  ];
  const { stdout, stderr, status } = spawnSync(process.execPath, [here('../bin/parcours.mjs'), ...args], {
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(`${run.folder} ended with ${status}: ${stderr}`);
  const report = JSON.parse(stdout.trim().split('\n').at(-1));
  process.stdout.write(
    `${run.folder}: ${report.ended}, ${verdictOf(report)}, ${report.realTimeFactor} x real time, ${report.robot.collisions} collisions\n`,
  );
  run.traceHash = report.traceHash;
  run.passedMs = report.verdict?.state === 'passed' ? report.verdict.atMs : null;
  if (run.folder.startsWith('golden/')) return;
  writeFileSync(here(`${run.folder}/expected.csv`), thinned(readFileSync(trace, 'utf8')));
}

/** What the course says to it; a solution that does not pass its own course is not worth a recording. */
function verdictOf({ verdict }) {
  if (verdict === null) return 'no task';
  if (verdict.state !== 'passed') throw new Error(`its task is not passed: ${JSON.stringify(verdict)}`);
  return `passed after ${verdict.atMs} ms`;
}

/** The first four columns of every n-th row. */
function thinned(csv) {
  const [header, ...rows] = csv.trim().split('\n');
  const every = Math.ceil(rows.length / MAX_ROWS);
  const kept = [header, ...rows.filter((_, index) => index % every === 0)];
  return `${TOLERANCE}\n${kept.map((row) => row.split(',').slice(0, 4).join(',')).join('\n')}\n`;
}
