import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import Ajv from 'ajv';
import Ajv2020 from 'ajv/dist/2020.js';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parse } from 'yaml';
import { projectToText } from '#project/file';
import { readyProject } from '../../src/cli/ready-courses';

const HERE = 'examples/autograders';
const folder = mkdtempSync(join(tmpdir(), 'parcours-autograders-'));
afterAll(() => rmSync(folder, { recursive: true }));

const RIGHT = readFileSync('courses/closed-line/main.py', 'utf8');
/** Keeps one check of three, and is not passed. */
const STANDING = 'from microbit import *\nwhile True:\n    sleep(1000)\n';
/** The checks of the task and their worlds. */
const TASK = {
  version: 1,
  checks: [
    { type: 'goals', points: 2 },
    { type: 'loop', points: 1 },
    { type: 'calls', name: 'setSpeed', points: 0.5, needed: false },
  ],
  worlds: [{ id: 'other motors', reality: 0.1, seed: 3 }],
  stars: [3, 3.5],
  seconds: 30,
};

function write(path, text) {
  mkdirSync(dirname(join(folder, path)), { recursive: true });
  writeFileSync(join(folder, path), text);
  return join(folder, path);
}

/** Runs a program to its end. */
function run(command, args, options = {}) {
  const { status, stdout, stderr } = spawnSync(command, args, { encoding: 'utf8', ...options });
  return { code: status, out: stdout, err: stderr };
}
const parcours = (...args) => run(process.execPath, ['bin/parcours.mjs', 'check', join(folder, 'task.json'), ...args]);
const script = (path, ...args) => run(process.execPath, [`${HERE}/${path}`, ...args]);

/** The result of somebody alone, as a file. */
function resultOf(name) {
  const { out } = parcours(join(folder, 'class', name), '--json');
  return write(`${name}.json`, out);
}

/** The result of all, as a file. */
let all = '';
beforeAll(() => {
  write('task.json', projectToText({ ...readyProject('closed-line'), task: TASK }));
  // As Moodle packs what is handed in.
  write('class/Anna Weber_17_assignsubmission_file/main.py', RIGHT);
  write('class/Ben Huber_18_assignsubmission_file/robot.py', STANDING);
  write('class/Ben Huber_18_assignsubmission_onlinetext/onlinetext.html', '<p>My file is above.</p>');
  write('class/Cem Öz_19_assignsubmission_file/photo.jpg', '…');
  write('class/Dora Roth_20_assignsubmission_file/main.py', `# mine\n${RIGHT}`);
  all = write('all.json', parcours(join(folder, 'class'), '--json', '--junit', join(folder, 'all.xml')).out);
  for (const [name, text] of [['anna.py', RIGHT], ['ben.py', STANDING], ['cem.jpg', '…']]) write(`alone/${name}`, text); // prettier-ignore
}, 60_000);

describe('the JSON schema of a result', () => {
  const schema = JSON.parse(readFileSync('schemas/check-result.schema.json', 'utf8'));
  /** Every field must be described. */
  const strict = (part) =>
    typeof part !== 'object' || part === null || Array.isArray(part)
      ? part
      : {
          ...Object.fromEntries(Object.entries(part).map(([name, inner]) => [name, strict(inner)])),
          ...(part.type === 'object' && part.properties !== undefined && { additionalProperties: false }),
        };
  const check = new Ajv2020({ allowUnionTypes: true }).compile(strict(schema));
  const problemsOf = (value) => {
    check(value);
    return check.errors;
  };

  it('describes every field of results: passed, failed, unread, with stars and hidden worlds', () => {
    const result = JSON.parse(readFileSync(all, 'utf8'));
    expect(problemsOf(result)).toBeNull();
    expect(result).toMatchObject({ maxPoints: 3.5, passed: 2, of: 5 });
    expect(result.handIns.map(({ points, stars }) => [points, stars ?? null])).toEqual([[3.5, 3], [1, 0], [null, null], [null, null], [3.5, 3]]); // prettier-ignore
    expect(result.handIns[0].worlds.map(({ id, hidden }) => [id, hidden])).toEqual([['visible', false], ['other motors', true]]); // prettier-ignore
  });

  it('describes that of a ready course', () => {
    const { out } = run(process.execPath, ['bin/parcours.mjs', 'check', 'closed-line', join(folder, 'class'), '--json', '--lang', 'fr']); // prettier-ignore
    expect(problemsOf(JSON.parse(out))).toBeNull();
  });

  it('is the form of the example in the manual', () => {
    const manual = readFileSync('docs/command-line.md', 'utf8');
    const [, example = ''] = /```json\n(\{\n {2}"task":[^`]*)```/.exec(manual) ?? [];
    expect(problemsOf(JSON.parse(example))).toBeNull();
  });

  it('refuses what has another form', () => {
    const result = JSON.parse(readFileSync(all, 'utf8'));
    expect(problemsOf({ ...result, of: '5' })).not.toBeNull();
    expect(problemsOf({ ...result, wallMs: 12 })).not.toBeNull();
  });
});

describe('the example for Moodle', () => {
  const WORKSHEET = `\ufeffIdentifier,"Full name","Email address",Status,Grade,"Maximum grade","Grade can be changed","Last modified (submission)","Last modified (grade)","Feedback comments"
"Participant 17","Anna Weber",anna@school.example,"Submitted for grading",,100.00,Yes,"Friday, 20 November 2026, 8:15 AM",-,
"Participant 18","Ben Huber",ben@school.example,"Submitted for grading",,100.00,Yes,"Friday, 20 November 2026, 8:20 AM",-,
"Participant 19","Cem Öz",cem@school.example,"Submitted for grading",,100.00,Yes,"Friday, 20 November 2026, 8:25 AM",-,
"Participant 21","Eli ""Eel"" Frei",eli@school.example,"No submission",,100.00,Yes,-,-,
`;
  const cellsOf = (text) => text.trimEnd().split('\n').map((row) => row.split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/)); // prettier-ignore

  it('fills in grades and reasons, and leaves the rest of the worksheet as it is', () => {
    const { code, out, err } = script('moodle/grades.mjs', all, write('worksheet.csv', WORKSHEET), '--max', '100');
    const rows = cellsOf(out);
    expect(code).toBe(0);
    expect(rows.map((row) => [row[0], row[4], row[9]])).toEqual([
      ['Identifier', 'Grade', 'Feedback comments'],
      ['Participant 17', '100', ''],
      [
        'Participant 18',
        '28.57',
        expect.stringContaining(
          'The robot never moved. The program was still running after 30 s, the limit of this check.',
        ),
      ],
      ['Participant 19', '', 'cannot be read: the folder has no program (main.py).'],
      ['Participant 21', '', ''],
    ]);
    expect(rows[4]?.[1]).toBe('"Eli ""Eel"" Frei"');
    expect(rows[1]?.[7]).toBe('"Friday, 20 November 2026, 8:15 AM"');
    expect(err).toBe('Nobody in the worksheet has handed in: Dora Roth_20_assignsubmission_file\n');
    expect(out).not.toContain('Same program');
  });

  it('takes the headings of another language, and says which there are', () => {
    const german = WORKSHEET.replace('Status,Grade,', 'Status,Punkte,').replace('Feedback comments', 'Kommentar');
    const sheet = write('german.csv', german);
    const { out } = script('moodle/grades.mjs', all, sheet, '--grade', 'Punkte', '--feedback', 'Kommentar');
    expect(cellsOf(out).map((row) => row[4])).toEqual(['Punkte', '3.5', '1', '', '']);
    const refused = script('moodle/grades.mjs', all, sheet);
    expect([refused.code, refused.out]).toEqual([1, '']);
    expect(refused.err).toContain('The worksheet has no column Grade, Bewertung');
    expect(refused.err).toContain('It has: Identifier, Full name,');
  });

  it('makes a table for the gradebook of hand-ins that are called like users', () => {
    const { out } = script('moodle/grades.mjs', resultOf('../alone'));
    expect(cellsOf(out).map((row) => row.slice(0, 2))).toEqual([
      ...[['name', 'grade'], ['anna', '3.5'], ['ben', '1'], ['cem', '']], // prettier-ignore
    ]);
  });
});

describe('the example for Gradescope', () => {
  /** Its folders, with one pupil's files. */
  function grade(name, files) {
    const root = join(folder, `gradescope-${name}`);
    mkdirSync(join(root, 'source'), { recursive: true });
    symlinkSync(resolve('dist/cli'), join(root, 'source/parcours'));
    for (const one of ['task.json', 'results.mjs'])
      cpSync(one === 'task.json' ? join(folder, one) : `${HERE}/gradescope/${one}`, join(root, 'source', one));
    for (const [file, text] of Object.entries(files)) write(`gradescope-${name}/submission/${file}`, text);
    const { code } = run('bash', [`${HERE}/gradescope/run_autograder`], { env: { ...process.env, AUTOGRADER: root } });
    expect(code).toBe(0);
    return JSON.parse(readFileSync(join(root, 'results/results.json'), 'utf8'));
  }

  it('has a case for each check, and those of hidden worlds are hidden', () => {
    const { score, output, tests } = grade('right', { 'main.py': RIGHT });
    expect([score, output]).toEqual([3.5, 'Passed. ★★★']);
    expect(tests.map((one) => [one.name, one.score ?? null, one.max_score ?? null, one.visibility])).toEqual([
      ['goals', 2, 2, 'visible'],
      ['loop', 1, 1, 'visible'],
      ['calls', 0.5, 0.5, 'visible'],
      ['World: visible', null, null, 'visible'],
      ['World: other motors', null, null, 'hidden'],
    ]);
  });

  it('says why not, and does not grade what cannot be read', () => {
    const standing = grade('standing', { 'robot.py': STANDING });
    expect([standing.score, standing.output]).toEqual([1, 'Not passed yet. ☆☆☆']);
    expect(standing.tests[0]).toMatchObject({
      status: 'failed',
      score: 0,
      output: 'The robot never moved. The program was still running after 30 s, the limit of this check.',
    });
    const photo = grade('photo', { 'photo.jpg': '…' });
    expect([photo.score, photo.output]).toEqual([undefined, 'cannot be read: the folder has no program (main.py).']);
    expect(photo.tests.every(({ status, score }) => status !== 'passed' && score === undefined)).toBe(true);
    const several = grade('several', { 'a.py': RIGHT, 'b.py': STANDING });
    expect(several.score).toBeUndefined();
    expect(several.output).toContain('There are several: a.py, b.py.');
  });
});

describe('the example for GitHub Classroom', () => {
  const workflow = parse(readFileSync(`${HERE}/github-classroom/classroom.yml`, 'utf8'));

  it('is a workflow as GitHub describes it', () => {
    const schema = JSON.parse(readFileSync('examples/scale/schemas/github-workflow.json', 'utf8'));
    const check = new Ajv({ strict: false, validateFormats: false }).compile(schema);
    check(workflow);
    expect(check.errors).toBeNull();
  });

  it('hands the points of a repository to the reporter', () => {
    for (const [name, text, status, score] of [
      ['right', RIGHT, 'pass', 3.5],
      ['standing', STANDING, 'fail', 1],
    ]) {
      write(`${name}/repository/main.py`, text);
      const repository = join(folder, name, 'repository');
      cpSync('dist/cli', join(repository, '.parcours'), { recursive: true });
      cpSync(join(folder, 'task.json'), join(repository, '.parcours/task.json'));
      cpSync(`${HERE}/github-classroom/points.mjs`, join(repository, '.parcours/points.mjs'));
      const temp = join(folder, name, 'temp');
      mkdirSync(temp);
      const { run: lines } = workflow.jobs['run-autograding-tests'].steps.find(({ id }) => id === 'parcours');
      const output = write(`${name}/output`, '');
      const env = { ...process.env, RUNNER_TEMP: temp, GITHUB_OUTPUT: output, GITHUB_REPOSITORY: 'class/line-anna' };
      expect(run('bash', ['-e', '-c', lines], { cwd: repository, env })).toEqual({ code: 0, out: '', err: '' });
      // As the reporter reads it.
      const [, encoded = ''] = /^result=(.*)\n$/.exec(readFileSync(output, 'utf8')) ?? [];
      const result = JSON.parse(Buffer.from(encoded, 'base64').toString('utf8'));
      expect([result.status, result.max_score]).toEqual([status, 3.5]);
      expect(result.tests.reduce((sum, one) => sum + one.score, 0)).toBe(score);
    }
  });

  it('tells no points of what cannot be read: the job fails, and says why', () => {
    const { code, out, err } = script('github-classroom/points.mjs', resultOf('Cem Öz_19_assignsubmission_file'));
    expect([code, out, err]).toEqual([
      1,
      '',
      'cannot be read: this is neither a program (.py) nor a project (.json).\n',
    ]);
  });
});

describe('the example for GitLab', () => {
  const pipeline = parse(readFileSync(`${HERE}/gitlab/.gitlab-ci.yml`, 'utf8'));

  it('is a pipeline as GitLab describes it', () => {
    const schema = JSON.parse(readFileSync('examples/scale/schemas/gitlab-ci.json', 'utf8'));
    const check = new Ajv({ strict: false, validateFormats: false }).compile(schema);
    check(pipeline);
    expect(check.errors).toBeNull();
  });

  it('ends with 0 for a pupil who has passed, else with 3 and a JUnit file that says why', () => {
    const pupil = (name, text) => {
      write(`${name}-gitlab/main.py`, text);
      const cwd = join(folder, `${name}-gitlab`);
      cpSync('dist/cli', join(cwd, '.parcours'), { recursive: true });
      cpSync(join(folder, 'task.json'), join(cwd, '.parcours/task.json'));
      const { code } = run('bash', ['-e', '-c', pipeline.check.script.join('\n')], { cwd });
      return [code, readFileSync(join(cwd, 'report.xml'), 'utf8')];
    };
    expect(pupil('right', RIGHT)[0]).toBe(0);
    const [code, junit] = pupil('standing', STANDING);
    expect(code).toBe(3);
    expect(junit).toContain(
      '<failure message="The robot never moved. The program was still running after 30 s, the limit of this check.">',
    );
  });
});

describe('answers to a form', () => {
  it('are a table whose links are the hand-ins, called by the cell before them', async () => {
    const { linkOf } = await import('#project/link/link');
    const { readyCourse } = await import('../../src/cli/ready-courses');
    const addressOf = (text) => {
      const project = { ...readyProject('closed-line'), files: [{ name: 'main.py', text }] };
      return `https://parcours.example/${linkOf(project, { courses: readyCourse, program: true })?.fragment.replace(/^#?/, '#')}`;
    };
    const answers = `Timestamp,Name,Link\n"20/11/2026, 08:15:00",Anna Weber,${addressOf(RIGHT)}\n"20/11/2026, 08:20:00",Ben Huber,${addressOf(STANDING)}\n`;
    const { out } = parcours(write('answers.csv', answers), '--json');
    expect(JSON.parse(out).handIns.map(({ name, points }) => [name, points])).toEqual([['Anna Weber', 3.5], ['Ben Huber', 1]]); // prettier-ignore
  });
});
