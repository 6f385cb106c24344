import { execFile } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import Ajv from 'ajv';
import Ajv2020 from 'ajv/dist/2020.js';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parse } from 'yaml';

const HERE = 'examples/scale';
const read = (path) => readFileSync(`${HERE}/${path}`, 'utf8');
const recipe = (path) => parse(read(path));
const schema = (path) => JSON.parse(read(`schemas/${path}`));

const folders = [];
afterAll(() => folders.forEach((folder) => rmSync(folder, { recursive: true })));

/** A place with a class of nine, as a system lays it for a job: the hand-ins in `class`, the command line in `parcours`. */
function place(lay = symlinkSync) {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-scale-'));
  folders.push(folder);
  mkdirSync(join(folder, 'class'));
  // They end at once, so that only the sharing takes time.
  for (let pupil = 1; pupil <= 9; pupil += 1)
    writeFileSync(join(folder, 'class', `pupil-${pupil}.py`), `x = ${pupil}\n`);
  lay(resolve('dist/cli'), join(folder, 'parcours'));
  return folder;
}

/** Carries out a line of a recipe as its system does. */
function sh(line, cwd, environment = {}) {
  const env = { PATH: process.env.PATH, HOME: cwd, ...environment };
  return new Promise((done, fail) =>
    execFile('bash', ['-e', '-c', line], { cwd, env }, (error, out) => (error ? fail(error) : done(out))),
  );
}

const seven = (work) => Promise.all(Array.from({ length: 7 }, (_, at) => work(at)));
const table = (path) => readFileSync(path, 'utf8');

/** The result of the class from one machine, which has nothing of Parcours but a copy of the command line's folder. */
let expected = '';
beforeAll(async () => {
  const alone = place((from, to) => cpSync(from, to, { recursive: true }));
  await sh('node parcours/main.mjs check closed-line class --csv alone.csv || [ $? -eq 3 ]', alone);
  expected = table(join(alone, 'alone.csv'));
});

describe('the recipe for GitHub Actions', () => {
  const workflow = recipe('github-actions/check-class.yml');
  const linesOf = (job) => workflow.jobs[job].steps.flatMap(({ run }) => run ?? []);

  it('is a workflow as GitHub describes it', () => {
    const check = new Ajv({ strict: false, validateFormats: false }).compile(schema('github-workflow.json'));
    check(workflow);
    expect(check.errors).toBeNull();
    check({ ...workflow, jobs: { check: { 'runs-on': 'ubuntu-latest', steps: [{ runs: 'x' }] } } });
    expect(check.errors).not.toBeNull();
  });

  it('gives the table of one machine with its seven parts, each on a machine of its own', async () => {
    const { part } = workflow.jobs.check.strategy.matrix;
    const report = place();
    for (const one of await Promise.all(part.map((number) => checked(number))))
      cpSync(join(one, 'results'), join(report, 'results'), { recursive: true });
    await sh(linesOf('report')[0], report);
    expect(table(join(report, 'report.csv'))).toBe(expected);

    async function checked(number) {
      const machine = place();
      await sh(linesOf('check')[0], machine, { TASK: 'closed-line', PART: String(number) });
      return machine;
    }
  });
});

describe('the recipe for GitLab', () => {
  const pipeline = recipe('gitlab/.gitlab-ci.yml');

  it('is a pipeline as GitLab describes it', () => {
    const check = new Ajv({ strict: false, validateFormats: false }).compile(schema('gitlab-ci.json'));
    check(pipeline);
    expect(check.errors).toBeNull();
    check({ ...pipeline, check: { ...pipeline.check, parallel: 'seven' } });
    expect(check.errors).not.toBeNull();
  });

  it('gives the table of one machine with its seven parts', async () => {
    const folder = place();
    const total = String(pipeline.check.parallel);
    await seven((at) =>
      sh(pipeline.check.script[0], folder, {
        TASK: 'closed-line',
        CI_NODE_INDEX: String(at + 1),
        CI_NODE_TOTAL: total,
      }),
    );
    await sh(pipeline.report.script[0], folder);
    expect(table(join(folder, 'report.csv'))).toBe(expected);
  });
});

describe('the recipe for Kubernetes', () => {
  const [job, report] = ['check-class', 'report'].map((name) => recipe(`kubernetes/${name}.yaml`));
  const check = new Ajv2020({ strict: false, validateFormats: false }).compile(schema('kubernetes-job.json'));

  it('is made of jobs as Kubernetes describes them', () => {
    for (const one of [job, report]) {
      check(one);
      expect(check.errors).toBeNull();
    }
    check({ ...job, spec: { ...job.spec, completionsMode: 'Indexed' } });
    expect(check.errors).not.toBeNull();
  });

  it('gives the table of one machine with its seven pods', async () => {
    const folder = place();
    cpSync(join(folder, 'class'), join(folder, 'hand-ins'), { recursive: true });
    mkdirSync(join(folder, 'bin'));
    symlinkSync(resolve('bin/parcours.mjs'), join(folder, 'bin/parcours'));
    const environment = { PATH: `${folder}/bin:${process.env.PATH}` };
    // In the pod the volume is /class.
    const lineOf = ({ spec }) => spec.template.spec.containers[0].args[0].replaceAll('/class/', `${folder}/`);
    await seven((at) => sh(lineOf(job), folder, { ...environment, JOB_COMPLETION_INDEX: String(at) }));
    await sh(lineOf(report), folder, environment);
    expect(job.spec.completions).toBe(7);
    expect(table(join(folder, 'report.csv'))).toBe(expected);
  });
});

describe('the recipe for Slurm', () => {
  it('gives the table of one machine with its seven tasks, of which one is run again alone', async () => {
    const folder = place();
    const line = `bash "${resolve(HERE, 'slurm/check-class.sbatch')}" closed-line "${folder}/class" "${folder}/results"`;
    const task = (id, tasks) =>
      sh(line, folder, {
        ...{ PARCOURS: resolve('.'), SLURM_CPUS_PER_TASK: '1', SLURM_ARRAY_TASK_ID: String(id) },
        ...{ SLURM_ARRAY_TASK_MIN: String(tasks[0]), SLURM_ARRAY_TASK_COUNT: String(tasks.length) },
      });
    const all = [1, 2, 3, 4, 5, 6, 7];
    await Promise.all(all.filter((id) => id !== 5).map((id) => task(id, all)));
    const merge = `node parcours/main.mjs check --merge results --csv report.csv || [ $? -eq 3 ]`;
    await expect(sh(merge, folder)).rejects.toThrow('1 of 9 hand-ins have no result yet: pupil-5.');
    await task(5, [5]);
    await sh(merge, folder);
    expect(table(join(folder, 'report.csv'))).toBe(expected);
  });
});
