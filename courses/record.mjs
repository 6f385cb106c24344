// npm run courses:record: drives every course and writes into golden.json how it went: the exact trace as a hash, when the
// task was passed, where the robot stood at the end. A new recording needs a reason in its commit. With names of courses
// behind it, only those. The trajectory itself, a row every 20 ms:
// npx parcours run courses/square/main.py --scene courses/square/scene.json --trace square.csv
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

const only = process.argv.slice(2);
const golden = JSON.parse(readFileSync(here('golden.json'), 'utf8'));
for (const run of golden.runs) if (only.length === 0 || only.includes(run.folder)) record(run);
writeFileSync(here('golden.json'), `${JSON.stringify(golden, null, 2)}\n`);

function record(run) {
  const files = [here(`${run.folder}/main.py`), '--scene', here(`${run.folder}/scene.json`), ...furtherOf(run.folder)];
  const args = ['run', ...files, '--for', `${run.forMs}ms`, '--seed', String(run.seed), '--json', '--quiet'];
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
  run.endMm = { x: report.robot.xMm, y: report.robot.yMm };
}

/** Its further devices, and what is pressed and tilted. */
function furtherOf(folder) {
  const data = here(`${folder}/course.json`);
  const { devices = [] } = existsSync(data) ? JSON.parse(readFileSync(data, 'utf8')) : {};
  const inputs = here(`${folder}/inputs.json`);
  return [
    ...devices
      .slice(1)
      .flatMap(({ name, robot }) => ['--device', `${name}=${here(`${folder}/${name}.py`)},robot=${robot}`]),
    ...(existsSync(inputs) ? ['--input', inputs] : []),
  ];
}

/** The verdict of its course; a solution that does not pass its own course is not worth a recording. */
function verdictOf({ verdict }) {
  if (verdict === null) return 'no task';
  if (verdict.state !== 'passed') throw new Error(`its task is not passed: ${JSON.stringify(verdict)}`);
  return `passed after ${verdict.atMs} ms`;
}
