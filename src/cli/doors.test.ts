import { describe, expect, it } from 'vitest';
import { contentOf } from '#intake/sources';
import { addresses, samples } from '#intake/testing/samples';
import { parseCommand } from './arguments';
import type { RunOptions } from './run-arguments';
import { readTask } from './check/read-task';
import { findHandIns } from './check/sources';
import { readRunFiles } from './read-files';
import { useFolder } from './testing/parcours';

const { file } = useFolder();

/** The program that runs, or the reason why none does. */
async function run(word: string): Promise<string> {
  const command = parseCommand(['run', word]) as { readonly options: RunOptions };
  const read = await readRunFiles(command.options);
  return 'problem' in read ? read.problem : `${read.scene.name}: ${read.files['main.py']?.trim() ?? ''}`;
}
const task = async (word: string): Promise<string> => {
  const read = await readTask(word);
  return 'problem' in read ? read.problem : read.name;
};
async function handIns(word: string): Promise<string> {
  const read = await findHandIns([word]);
  if ('problem' in read) return read.problem;
  const found = await Promise.all(
    read.sources.map(async (source) => {
      const content = await contentOf(source);
      const what = 'handIn' in content ? content.handIn.project.files[0]?.text.trim() : content.problem.code;
      return `${source.name} ${what ?? ''}`;
    }),
  );
  return found.join(', ');
}

/** The meaning of each file as a program to run, as a task, and as a hand-in. */
const files: Readonly<Record<string, readonly [run: string, task: string, handIn: string]>> = {
  'anna.py': [': forward()', 'not JSON', 'anna forward()'],
  'anna.hex': [': forward()', 'not JSON', 'anna forward()'],
  'anna.parcours.json': ['Hall: forward()', 'Hall', 'anna forward()'],
  'without-ending': ['Hall: forward()', 'Hall', 'without-ending forward()'],
  'hall.json': ['is a course without a program', 'Hall', 'hall course'],
  'mylevel.json': ['is a course without a program', 'the course has no goals', 'mylevel course'],
  'week.json': ['is a series of tasks', 'is a series. Say which', 'week project'],
  'anna.run.json': ['is a recorded run', 'neither a project nor a course', 'anna forward()'],
  'cup.json': ['is a tournament', 'is a tournament', 'cup tournament'],
  'class.zip': ['is a zip', 'is a zip', 'Anna forward(), Ben '],
  'week.zip': ['is a zip', 'is a zip', '02-ans-ziel forward()'],
  'links.txt': [': Anna:', 'not JSON', 'Anna forward()'],
  'links.csv': [': Name', 'not JSON', 'Anna forward()'],
  'links.eml': [': From', 'not JSON', 'Anna forward()'],
  'attached.eml': [': From', 'not JSON', 'Anna forward()'],
  'walk.csv': [': Time', 'not JSON', 'walk no-link'],
  'floor.png': ['is not text', 'is not text', 'floor kind'],
  'broken.json': ['not JSON', 'not JSON', 'broken project'],
  'broken.py': ['is not text', 'is not text', 'broken not-text'],
  'broken.zip': ['is a zip', 'is a zip', 'broken.zip zip'],
  'blocks.hex': ['program from MakeCode', 'not JSON', 'blocks hex-makecode'],
  'film.mp4': [': ', 'not JSON', 'film kind'],
};

describe.each(samples)('$name', ({ name, bytes }) => {
  const [asProgram, asTask, asHandIn] = files[name] ?? ['', '', ''];
  it('is run', async () => expect(await run(file(name, bytes))).toContain(asProgram));
  it('is a task', async () => expect(await task(file(name, bytes))).toContain(asTask));
  it('is a hand-in', async () => expect(await handIns(file(name, bytes))).toContain(asHandIn));
});

const links: Readonly<Record<string, readonly [run: string, task: string, handIn: string]>> = {
  program: [': forward()', 'is a program', 'link 1 forward()'],
  course: ['is a course without a program', 'the course has no goals', 'link 1 course'],
  project: ['Hall: forward()', 'Hall', 'link 1 forward()'],
  recording: ['is a recorded run', 'is a recorded run', 'link 1 forward()'],
  'series-link': ['neither a project nor a program', 'is a series. Say which', 'link 1 no-work'],
  'series-place': ['neither a project nor a program', 'lies on a web server', 'link 1 no-work'],
  ready: ['neither a project nor a program', 'neither a project nor a program', 'link 1 no-work'],
  unreadable: ['neither a project nor a program', 'neither a project nor a program', 'link 1 no-work'],
};

describe.each(Object.entries(addresses))('an address: %s', (kind, address) => {
  const [asProgram, asTask, asHandIn] = links[kind] ?? ['', '', ''];
  it('is run', async () => expect(await run(address)).toContain(asProgram));
  it('is a task', async () => expect(await task(address)).toContain(asTask));
  it('is a hand-in', async () => expect(await handIns(address)).toContain(asHandIn));
});
