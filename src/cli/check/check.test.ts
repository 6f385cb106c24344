import { spawnSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  linkSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { projectOf, type Course } from '#catalogue/course';
import { withSolution } from '#catalogue/read-courses';
import { courses } from '#catalogue/courses';
import { missions } from '#catalogue/missions';
import { projectToText } from '#project/file';
import { linkOf } from '#project/link/link';
import { readyCourse, readyProject } from '../ready-courses';
import { parcours, useFolder } from '../testing/parcours';

const { folder, file } = useFolder();

const RIGHT = readFileSync('courses/closed-line/main.py', 'utf8');
/** Touches nothing, reaches nothing, and never ends: at rest it takes a third of the time to run of one that is at work. */
const RESTING = 'from microbit import *\nwhile True:\n    sleep(1000)\n';

/** A class in a folder of its own, each program by its name. */
function classOf(name: string, programs: Readonly<Record<string, string>>): string {
  mkdirSync(join(folder, name), { recursive: true });
  for (const [path, text] of Object.entries(programs)) {
    mkdirSync(join(folder, name, path, '..'), { recursive: true });
    writeFileSync(join(folder, name, path), text);
  }
  return join(folder, name);
}

interface Json {
  readonly task: string;
  readonly passed: number;
  readonly of: number;
  readonly handIns: readonly {
    readonly name: string;
    readonly passed: boolean;
    readonly points: number | null;
    readonly worlds: readonly { readonly id: string; readonly passed: boolean; readonly reason: string | null }[];
    readonly remarks: readonly string[];
  }[];
}

const jsonOf = (text: string): Json => JSON.parse(text) as Json;

describe('parcours check', () => {
  const pupils = {
    'anna.py': RIGHT,
    'ben.py': RESTING,
    'cem.py': 'while True: print("x" * 1000)\n',
    'dora/main.py': `# mine\n${RIGHT.replaceAll('left_bright', 'l')}`,
    'eli.py': 'x = (\n',
    'fritz.py': 'a = []\nwhile True: a.append(bytearray(100))\n',
    'gina.txt.bin': 'hello',
    'hugo/other.py': 'x = 1\n',
    'hugo/more.py': 'x = 2\n',
  };

  it('says of each hand-in of a class whether it has passed, and why not', () => {
    const { code, out } = parcours('check', 'closed-line', classOf('class', pupils), '--json');
    const { task, handIns, passed, of } = jsonOf(out);
    expect([code, task, passed, of]).toEqual([3, 'closed-line', 2, 8]);
    expect(handIns.map((one) => [one.name, one.passed, one.points])).toEqual([
      ...[['anna', true, 1], ['ben', false, 0], ['cem', false, 0], ['dora', true, 1]], // prettier-ignore
      ...[['eli', false, 0], ['fritz', false, 0], ['gina.txt', false, null], ['hugo', false, null]], // prettier-ignore
    ]);
    expect(handIns[0]?.worlds).toEqual([{ id: 'visible', hidden: false, passed: true, reason: null, atMs: 19480, touches: 0 }]); // prettier-ignore
    expect(handIns[0]?.remarks).toEqual(['Same program as: dora']);
    expect(handIns[4]?.worlds[0]?.reason).toContain('SyntaxError');
    expect(handIns[5]?.worlds[0]?.reason).toContain('MemoryError');
    expect([handIns[6]?.remarks[0], handIns[7]?.remarks[0]]).toEqual([
      'cannot be read: this is neither a program (.py) nor a project (.json).',
      'cannot be read: which file is the program? There are several: more.py, other.py.',
    ]);
  });

  it('prints lines for people, in their language, without --json', () => {
    const { code, out } = parcours('check', 'closed-line', classOf('two', { 'anna.py': RIGHT, 'ben.py': RESTING }), '--lang', 'de'); // prettier-ignore
    expect(code).toBe(3);
    expect(out.split('\n')).toEqual([
      'bestanden  anna  1  19.5 s',
      'nicht bestanden  ben  0  Der Roboter hat sich nie bewegt. Das Programm lief nach 300 s noch, und länger dauert diese Prüfung nicht.',
      'closed-line: 1 von 2 bestanden',
      '',
    ]);
  });

  it('says how to choose where several files may be the program, and checks the one that is taken', () => {
    const here = classOf('several', { 'Tim_7_assignsubmission_file_/main.txt.py': RIGHT, 'Tim_7_assignsubmission_file_/b.py': 'x', 'Ben.py': 'x' }); // prettier-ignore
    const [name, table] = ['Tim_7_assignsubmission_file_', join(folder, 'several.csv')];
    const asked = parcours('check', 'closed-line', here, '--lang', 'de');
    expect(asked.out).toContain('Welche Datei ist das Programm? Es könnten mehrere sein: b.py, main.txt.py.');
    expect(asked.err).toContain('so: --take "Tim=b.py"');
    expect(parcours('check', 'closed-line', here, '--take', 'Tim=main.txt.py').out).toContain('passed  Tim');
    const take = ['--take', `${name}=main.txt.py`, '--table', table, '--lang', 'de'];
    expect(parcours('check', 'closed-line', here, ...take)).toMatchObject({ code: 3, out: expect.stringContaining('1 von 2') as string, err: '' }); // prettier-ignore
    expect(readFileSync(table, 'utf8')).toMatch(/^\ufeffName;.*\r\nBen;nicht bestanden;0;1;.*\r\nTim;bestanden;1;1;bestanden;bestanden;19,48;0;\r\n$/s); // prettier-ignore
    expect(parcours('check', 'closed-line', here, '--take', 'Eva=b.py')).toMatchObject({ code: 2 });
  });

  it.runIf(existsSync('/dev/full'))(
    'writes the other reports and says the results where one does not fit on the disk',
    () => {
      const here = classOf('full', { 'anna.py': 'x = 1\n' });
      const tests = join(folder, 'beside-full.xml');
      const { code, out, err } = parcours('check', 'closed-line', here, '--csv', '/dev/full', '--junit', tests);
      expect([code, err]).toEqual([2, 'parcours: --csv: /dev/full: the disk is full.\n']);
      expect(out).toContain('closed-line: 0 of 1 passed');
      expect(readFileSync(tests, 'utf8')).toContain('anna');
    },
  );

  it('keeps what a program says to one line, and from steering the terminal', () => {
    const here = classOf('steering', { 'anna.py': 'raise Exception("a\\nb\\x1b[2J")\n' });
    const { out } = parcours('check', 'closed-line', here);
    expect(out).toBe('failed  anna  0  Line 1: Exception: a b\\x1b[2J\nclosed-line: 0 of 1 passed\n');
  });

  it('ends with 0 when all have passed', () => {
    expect(parcours('check', 'closed-line', file('right.py', RIGHT), '--quiet')).toEqual({ code: 0, out: '', err: '' });
  });

  it('takes a zip like its folder, and gives the same text with any number of threads', () => {
    const several = { ...pupils, 'ben.py': RESTING, 'cem.py': 'print("x")\n', 'fritz.py': 'y\n' };
    const zip = zipSync(Object.fromEntries(Object.entries(several).map(([path, text]) => [`class/${path}`, strToU8(text)]))); // prettier-ignore
    const path = join(folder, 'class.zip');
    writeFileSync(path, zip);
    const [one, four] = ['1', '4'].map((jobs) => parcours('check', 'closed-line', path, '--json', '--jobs', jobs).out);
    expect(one).toBe(four);
    expect(one).toBe(parcours('check', 'closed-line', classOf('threads/class', several), '--json').out);
  });

  it('tells of what lies in a folder and leads nowhere, and of a folder or zip without anything', () => {
    const here = classOf('strange', { 'anna.py': RIGHT, 'ben/main.py': RIGHT });
    symlinkSync('/nowhere', join(here, 'gone.py'));
    symlinkSync('/nowhere', join(here, 'ben', 'gone.mp4'));
    const zip = join(folder, 'empty.zip');
    writeFileSync(zip, zipSync({}));
    const { handIns } = jsonOf(parcours('check', 'closed-line', here, zip, classOf('nobody', {}), '--json').out);
    expect(handIns.map(({ name, passed, remarks }) => [name, passed, remarks.at(-1) ?? ''])).toEqual([
      ['anna', true, 'Same program as: ben'],
      ['ben', true, 'Same program as: anna'],
      ['empty.zip', false, 'cannot be read: the folder has no program (main.py).'],
      ['gone', false, 'cannot be read: the file could not be read (there is no such file.).'],
      ['nobody', false, 'cannot be read: the folder has no program (main.py).'],
    ]);
    expect(parcours('check', 'closed-line', join(folder, 'nobody'))).toMatchObject({ code: 2, err: expect.stringContaining('there are no hand-ins') as string }); // prettier-ignore
  });

  it.each([
    [['check', 'closed-line', 'nowhere/'], 'nowhere/: there is no such file.'],
    [['check', 'no-such-course', 'package.json'], 'There is no ready course "no-such-course" either.'],
    [['check', 'closed-lin', 'package.json'], 'Did you mean closed-line?'],
    [['check', 'closed-line', 'bin', '--decimals', 'comma'], '--decimals: there is no table for a spreadsheet.'],
    [['check', 'package.json', 'README.md'], 'package.json: '],
    [['check', '--merge', 'src'], 'src: is no folder of results'],
    [['check', 'closed-line', 'bin', '--csv', 'a', '--junit', 'a'], '--junit and --csv: a can be only one of them.'],
  ])('refuses %j', (words, problem) => {
    const { code, out, err } = parcours(...words);
    expect([code, out]).toEqual([2, '']);
    expect(err).toContain(problem);
  });

  it('writes over nothing that was handed in, and not over its task', () => {
    const here = classOf('kept', { 'anna/main.py': RIGHT, 'ben.txt': 'x' });
    const task = file('kept-task.json', projectToText(readyProject('closed-line')!));
    linkSync(join(here, 'anna/main.py'), join(folder, 'hard.csv'));
    for (const [words, option, path] of [
      [[task, here, '--csv', join(folder, 'hard.csv')], '--csv', join(folder, 'hard.csv')],
      [[task, here, '--junit', join(here, 'ben.txt')], '--junit', join(here, 'ben.txt')],
      [[task, here, '--report', task], '--report', task],
    ] as const) {
      const { code, err } = parcours('check', ...words);
      expect([code, err]).toEqual([2, `parcours: ${option}: ${path} is read by this check. Choose another name.\n`]);
    }
    const { code, err } = parcours('check', 'closed-line', '--csv', join(here, 'cem.py'), here);
    expect([code, err]).toEqual([2, expect.stringContaining('is called like a program')]);
    expect(readFileSync(join(here, 'anna/main.py'), 'utf8')).toBe(RIGHT);
    expect(readFileSync(join(here, 'ben.txt'), 'utf8')).toBe('x');
  });

  it('takes a mission by its id, calls it by its title, and tells of its start program in whatever language', () => {
    const mission = missions.find(({ id }) => id === 'closed-line-maqueen-lite')!;
    const { program, solution, texts } = mission;
    const written = Object.fromEntries(Object.entries(program).map(([language, text]) => [`${language}.py`, text]));
    const handedIn = classOf('mission', { ...written, 'own.py': solution.de });
    const report = join(folder, 'mission.html');
    const { out } = parcours('check', mission.id, handedIn, '--json', '--lang', 'fr', '--report', report);
    const { task, handIns } = jsonOf(out);
    expect(task).toBe('closed-line-maqueen-lite');
    expect(handIns.map(({ name, passed, remarks }) => [name, passed, remarks.length])).toEqual([
      ...[['de', false, 1], ['en', false, 1], ['fr', false, 1], ['it', false, 1]], // prettier-ignore
      ['own', true, 0],
    ]);
    expect(readFileSync(report, 'utf8')).toContain(`<h1>${texts.fr.name}</h1>`);
  });

  it('takes a task of a series, which calls it something else in reports, also in those that are joined', () => {
    const tasks = [{ course: 'slalom' }, { title: 'Rund um den Tisch', course: 'closed-line' }];
    const series = file('week.json', JSON.stringify({ format: 'parcours-series', version: 1, title: 'Week', tasks }));
    const pupil = file('pupil.py', RIGHT);
    const [report, again, results] = ['series.html', 'again.html', 'series'].map((name) => join(folder, name));
    const { code, out } = parcours('check', `${series}#2`, pupil, '--json', '--report', report!, '--resume', results!);
    expect([code, jsonOf(out).task]).toEqual([0, 'Rund um den Tisch']);
    expect(readFileSync(report!, 'utf8')).toContain('<p>Rund um den Tisch ·');
    expect(parcours('check', '--merge', results!, '--json', '--report', again!).out).toBe(out);
    expect(readFileSync(again!, 'utf8')).toBe(readFileSync(report!, 'utf8'));
    const whole = parcours('check', series, pupil);
    expect([whole.code, whole.err]).toEqual([
      2,
      `parcours: ${series}: is a series. Say which of its tasks, such as ${series}#1: #1 (Slalom), #2 (Rund um den Tisch).\n`,
    ]);
  });

  describe('of a course with several devices', () => {
    const courseOf = (id: string): Course => courses.find((one) => one.id === id)!;
    const solved = (id: string): string =>
      file(`${id}.json`, projectToText(projectOf(withSolution(courseOf(id)), 'de')));

    it.each(['relay', 'bar'])('takes %s with all its devices, and the first one’s program alone', (id) => {
      const { out } = parcours('check', id, solved(id), join('courses', id, 'main.py'), '--json');
      const inOrder = [[id, true], ['main', true]].sort(); // prettier-ignore
      expect(jsonOf(out).handIns.map(({ name, passed }) => [name, passed])).toEqual(inOrder);
      const begun = file('begun.json', projectToText(projectOf(courseOf(id), 'de')));
      expect(jsonOf(parcours('check', id, begun, '--json').out).passed).toBe(0);
    });

    it.each(['remote-control', 'lead', 'hide', 'sumo'])('takes those of %s, whatever they are called', (id) => {
      expect(jsonOf(parcours('check', id, solved(id), '--json').out).handIns.map(({ passed }) => passed)).toEqual([true]); // prettier-ignore
    });
  });

  it('finds links in an e-mail, and tells of one that is damaged', () => {
    const project = readyProject('closed-line');
    if (project === null) throw new Error('There is no such course.');
    const handedIn = { ...project, files: [{ name: 'main.py', text: RIGHT }] };
    const { fragment = '' } = linkOf(handedIn, { courses: readyCourse, program: true }) ?? {};
    const address = `https://parcours.example/${fragment.replace(/^#?/, '#')}`;
    const mail = file(
      'mail.eml',
      `Good morning\n\nAnna: ${address}\nBen: ${address.slice(0, -40)}\nhttps://example.org\n`,
    );
    const { handIns } = jsonOf(parcours('check', 'closed-line', mail, '--json').out);
    expect(handIns.map(({ name, passed }) => [name, passed])).toEqual([['Anna', true], ['Ben', false]]); // prettier-ignore
    expect(handIns[1]?.remarks[0]).toContain('cannot be read: the link is damaged or not whole.');
  });

  it('finds a link that somebody has handed in as a text', () => {
    const project = readyProject('closed-line');
    if (project === null) throw new Error('There is no such course.');
    const handedIn = { ...project, files: [{ name: 'main.py', text: RIGHT }] };
    const { fragment = '' } = linkOf(handedIn, { courses: readyCourse, program: true }) ?? {};
    const address = `https://parcours.example/${fragment.replace(/^#?/, '#')}`;
    const texts = classOf('texts', {
      // As Moodle packs what is typed into it.
      'Anna Weber_17_assignsubmission_onlinetext/onlinetext.html': `<p>Mine: <a href="${address}">${address}</a></p>`,
      'ben.url': `[InternetShortcut]\r\nURL=${address}\r\n`,
      'cem.txt': `${address}\n${address.slice(0, -9)}\n`,
      'dora.txt': 'I was ill.\n',
    });
    const { handIns } = jsonOf(parcours('check', 'closed-line', texts, '--json').out);
    expect(handIns.map(({ passed }) => passed)).toEqual([true, true, false, false]);
    expect(handIns[2]?.remarks).toEqual(['cannot be read: the text has several links in it. A hand-in is one.']);
    expect(handIns[3]?.remarks).toEqual(['cannot be read: the text has no link to a program in it.']);
  });

  it('says of the teacher’s task which hidden world hides nothing', () => {
    const project = readyProject('closed-line');
    if (project === null) throw new Error('There is no such course.');
    const worlds = [{ id: '2' }, { id: '3', reality: 0.2, seed: 2 }];
    const solution = [{ name: 'main.py', text: RIGHT }];
    const task = file('hides.json', projectToText({ ...project, task: { version: 1, worlds, solution } }));
    const pupil = file('hidden.py', RIGHT);
    const { code, err } = parcours('check', task, pupil, '--lang', 'de');
    expect(code).toBe(0);
    expect(err).toContain('parcours: Welt 2 ist gleich wie Welt 1: Ändere Start, Abnutzung oder ein Ding.\n');
    expect(err).not.toContain('Welt 3');
    expect(parcours('check', task, pupil, '--quiet').err).toBe('');
  });

  it('goes on with the others when a thread gives no sign of life', () => {
    const copy = join(folder, 'hung');
    cpSync('dist/cli', copy, { recursive: true });
    const worker = join(copy, 'check-worker.mjs');
    // The first program that is asked for hangs in its world, asleep; asked once more, without that world, it has a result.
    const hang = "import { parentPort as port } from 'node:worker_threads';\nport.on('message', ({ handIn, lost }) => { if (!lost && handIn?.project.files[0].text.includes('hang')) Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0); });\n"; // prettier-ignore
    writeFileSync(worker, hang + readFileSync(worker, 'utf8'));
    const pupilsHere = classOf('hanging', { 'a.py': '# hang\n', 'b.py': RIGHT });
    const { status, stdout } = spawnSync(process.execPath, [join(copy, 'main.mjs'), 'check', 'closed-line', pupilsHere, '--json', '--jobs', '1'], { encoding: 'utf8' }); // prettier-ignore
    const { handIns } = jsonOf(stdout);
    expect(status).toBe(3);
    expect(handIns[0]?.worlds[0]?.reason).toBe('The program is stuck in a single call that does not end.');
    expect(handIns[1]?.passed).toBe(true);
  });
});

describe('results that are kept', () => {
  const pupils = classOf('kept-results', { 'a.py': RIGHT, 'b.py': RESTING, 'c.py': 'from mbrobot import *\nforward()\n', 'd.py': 'x' }); // prettier-ignore
  const results = join(folder, 'results');

  it('are byte for byte those of one machine when seven shards are joined', () => {
    for (let place = 1; place <= 7; place++)
      parcours('check', 'closed-line', pupils, '--resume', results, '--shard', `${place}/7`, '--quiet');
    const whole = ['report', 'csv', 'junit'].map((kind) => join(folder, `whole.${kind}`));
    const joined = ['report', 'csv', 'junit'].map((kind) => join(folder, `joined.${kind}`));
    const files = (paths: readonly string[]) => ['report', 'csv', 'junit'].flatMap((kind, at) => [`--${kind}`, paths[at] ?? '']); // prettier-ignore
    const one = parcours('check', 'closed-line', pupils, '--json', ...files(whole));
    expect(parcours('check', '--merge', results, '--json', ...files(joined))).toEqual(one);
    const read = (paths: readonly string[]) => paths.map((path) => readFileSync(path, 'utf8'));
    expect(read(joined)).toEqual(read(whole));
  });

  it('are not run again, but those of a program that has changed are', () => {
    const kept = readdirSync(join(results, 'results'));
    const path = join(results, 'results', kept[0] ?? '');
    const before = JSON.parse(readFileSync(path, 'utf8')) as { name: string; result: { points: number } };
    // A mark that no run would make.
    writeFileSync(path, JSON.stringify({ ...before, result: { ...before.result, points: 77 } }));
    const run = () => jsonOf(parcours('check', 'closed-line', pupils, '--resume', results, '--json').out).handIns;
    expect(run().find(({ name }) => name === before.name)?.points).toBe(77);
    writeFileSync(join(pupils, `${before.name}.py`), '# new\n');
    expect(run().find(({ name }) => name === before.name)?.points).toBe(0);
  });

  it('are not joined if some are missing, which are named', () => {
    const some = join(folder, 'some');
    parcours('check', 'closed-line', pupils, '--resume', some, '--shard', '1/2', '--quiet');
    const { code, err } = parcours('check', '--merge', some);
    expect(code).toBe(2);
    expect(err).toContain('2 of 4 hand-ins have no result yet: b, d.');
  });

  it('are refused if they are of another task', () => {
    const { code, err } = parcours('check', 'small-maze', pupils, '--resume', results);
    expect(code).toBe(2);
    expect(err).toContain('holds the results of another task');
  });
});

describe('parcours run --until-verdict', () => {
  it('ends with the verdict: 0 for a task that is passed, 3 for one that is not', () => {
    const right = parcours('run', 'courses/closed-line/main.py', '--scene', 'closed-line', '--until-verdict');
    expect(right).toMatchObject({ code: 0, err: 'Task: passed after 19.5 s.\n' });
    const early = parcours('run', file('early.py', 'x = 1\n'), '--scene', 'closed-line', '--until-verdict');
    expect(early).toMatchObject({ code: 3, err: expect.stringContaining('Task: not done') as string });
  });

  it('is refused in a course without a task', () => {
    const { code, err } = parcours('run', file('free.py', 'x = 1\n'), '--until-verdict');
    expect(code).toBe(2);
    expect(err).toContain('the course has no task');
  });
});
