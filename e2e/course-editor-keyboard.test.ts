import { test } from './app';
import {
  buildMazeAndMeetWall,
  drawTrackAndFollow,
  moveStart,
  saveReloadLoad,
  shareWith,
  undoFiveSteps,
} from './course-tasks';
import { IN_ONE_ENGINE } from './engines';
import { withKeys } from './keys';

test('by keyboard: a track is drawn, and the robot follows it', IN_ONE_ENGINE, async ({ app }) => {
  await drawTrackAndFollow(withKeys(app));
});

test('by keyboard: a maze of eight walls is built, and the robot meets one of them', IN_ONE_ENGINE, async ({ app }) => {
  await buildMazeAndMeetWall(withKeys(app));
});

test('by keyboard: the start is moved and turned, and the robot sets out from there', async ({ app }) => {
  await moveStart(withKeys(app));
});

test('by keyboard: five steps are taken back one by one, and done again', IN_ONE_ENGINE, async ({ app }) => {
  await undoFiveSteps(
    withKeys(app),
    () => app.press('Control', 'z'),
    () => app.press('Control', 'y'),
  );
});

test('by keyboard: a project is saved, is there after a reload, and is loaded', IN_ONE_ENGINE, async ({ app }) => {
  await saveReloadLoad(withKeys(app));
});

test('by keyboard: a link brings the project to another profile', IN_ONE_ENGINE, async ({ app, another }) => {
  await shareWith(withKeys(app), async () => withKeys(await another()));
});
