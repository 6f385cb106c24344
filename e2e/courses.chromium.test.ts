import { paintOf } from './arena';
import { expect, test } from './app';
import { drive, ends, sceneOf } from './course';
import { consoleIn, isThere } from './page';

// What a course's solution does is said by its golden run, and that a browser does the same by the test of sameness.

test('clear the ring: three blocks lie outside when the program is through', async ({ app }) => {
  await drive(app, 'clear-the-ring', 'Maqueen Lite');
  await ends(app, 'clear-the-ring');
  expect(await consoleIn(app)).toContain('pushed out: 3');
  const painted = await paintOf(app, 'blocks', sceneOf('clear-the-ring').size);
  expect(painted.length).toBeGreaterThan(0);
  const inside = painted.filter(({ x, y }) => Math.hypot(x - 500, y - 500) < 380 - 25);
  expect(inside).toEqual([]);
});

test('the maze with a bumper: the Calli:bot comes to the black line by touch', async ({ app }) => {
  await drive(app, 'bumper-maze', 'Calli:bot');
  await ends(app, 'bumper-maze');
  expect(await isThere(app, '.pane-arena .half')).toBe(true); // what the bumper feels, under the arena
});
