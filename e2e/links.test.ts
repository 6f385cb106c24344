import { linkOf, projectOfLink } from '../src/project/link/link';
import { drawings, drawn } from '../src/project/testing/drawings';
import { FORTY_LINES, fortyObjects, largeProject } from '../src/project/testing/projects';
import { expect, test } from './app';
import { linkFrom } from './course-tasks';
import { programIn } from './page';
import { openEditor } from './pupil';

/** Knows no ready course: all of the course is in the link. */
const none = (): null => null;

test('a link that was made elsewhere opens, and one that is made here opens elsewhere: the numbers are the same', async ({
  app,
}) => {
  const base = largeProject();
  const scribble = drawings['scribble'];
  if (scribble === undefined) throw new Error('There is no such drawing.');
  const scene = { ...base.scene, objects: [...drawn(scribble, 1), ...fortyObjects()] };
  const made = linkOf({ ...base, scene }, { courses: none, program: true });
  await openEditor(app);
  await app.goto(`./#${made?.fragment ?? ''}`);
  await expect.poll(() => programIn(app)).toContain(FORTY_LINES.split('\n').slice(0, 8).join('\n')); // the editor has no lines that are out of sight
  const link = await linkFrom(app);
  const read = projectOfLink(link.slice(link.indexOf('#')), none);
  expect('project' in read && read.project.scene).toEqual(scene);
  expect('project' in read && read.project.files).toEqual(base.files);
});
