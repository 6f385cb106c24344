import type { Page } from '@playwright/test';
import type { Point } from '../src/scene/scene';
import { inWindow } from './arena';
import { expect, test } from './app';
import { buildMazeAndMeetWall, drawTrackAndFollow, moveStart } from './course-tasks';
import { attribute } from './page';
import { by, gone, until } from './parts';
import { canUndo, clearAll, listOf, openEditor, SIZE, toolButton, toolsCame } from './pupil';
import { tablet, withFingers } from './touch';

test.use(tablet);

test('with fingers: a track is drawn, and the robot follows it', async ({ page }) => {
  await drawTrackAndFollow(await withFingers(page));
});

test('with fingers: a maze of eight walls is tapped, and the robot meets one of them', async ({ page }) => {
  await buildMazeAndMeetWall(await withFingers(page));
});

test('with fingers: the start is moved and turned, and the robot sets out from there', async ({ page }) => {
  await moveStart(await withFingers(page));
});

/** Places of the arena in small steps along a line. */
const line = (from: Point, to: Point): readonly Point[] =>
  Array.from({ length: 13 }, (_, i) => [
    from[0] + ((to[0] - from[0]) * i) / 12,
    from[1] + ((to[1] - from[1]) * i) / 12,
  ]);

/** Everything that could have been scrolled or zoomed by mistake. */
const pageAt = (page: Page): Promise<readonly number[]> =>
  page.evaluate(() => [
    window.visualViewport?.scale ?? 1,
    window.visualViewport?.offsetTop ?? 0,
    ...Array.from(document.querySelectorAll('*'), (element) => element.scrollTop + element.scrollLeft).filter(
      (px) => px !== 0,
    ),
  ]);

test('two fingers zoom the arena: they draw nothing, drop what one of them had begun, and scroll nothing', async ({
  page,
}) => {
  const pupil = await withFingers(page);
  const { app, fingers } = pupil;
  await openEditor(app);
  await clearAll(app);
  await pupil.chooseTool('pen');
  const places = (way: readonly Point[]): ReturnType<typeof inWindow> => inWindow(app, SIZE, way);
  const left = await places(line([550, 450], [300, 450]));
  const right = await places(line([650, 450], [900, 450]));
  const around = await places([[750, 450], [600, 450]]); // prettier-ignore
  const before = await pageAt(page);

  await fingers.drawTwo(left, right);
  await pupil.chooseTool('block');
  for (const place of around) await fingers.tapAt(place);
  const rows = await listOf(app);
  expect(rows).toHaveLength(3); // the robot’s start and two blocks, no line
  // As far apart as before is now less in the arena: 600 of 100 mm.
  const [there = NaN, middle = NaN] = rows.slice(1).map((row) => Number(/at ([\d.]+) \|/.exec(row)?.[1]) * 10);
  expect(Math.abs(middle - 600)).toBeLessThanOrEqual(10);
  expect(Math.abs(there - middle - 25)).toBeLessThanOrEqual(12);

  await fingers.tap(by('show'));
  await until(app, by('fit'));
  await fingers.tap(by('fit'));
  await gone(app, '[role=menu]');
  await pupil.chooseTool('pen');
  await fingers.drawTwo(await places(line([200, 200], [400, 200])), await places(line([700, 700], [800, 700])), 5);
  await fingers.drawTwo(await places(line([200, 200], [200, 700])), await places(line([700, 200], [700, 700])));
  expect(await listOf(app)).toEqual(rows);
  expect(await pageAt(page)).toEqual(before);

  await pupil.draw(line([200, 300], [400, 300])); // one finger draws again
  await expect.poll(() => app.text(by('editor-said'))).toContain('Line drawn');
});

test('a finger that rests on a tool reads what it is for; a tap chooses it, and the first tap in the arena acts', async ({
  page,
}) => {
  const { app, fingers } = await withFingers(page);
  await openEditor(app);
  const isChosen = (tool: string): Promise<string | null> => attribute(app, toolButton(tool), 'aria-pressed');
  await fingers.rest(toolButton('wall'));
  await expect.poll(() => page.locator('.bubble').allInnerTexts()).toEqual(['Draw a wall (W)']);
  await fingers.lift();
  await gone(app, '.bubble');
  expect(await isChosen('wall')).toBe('false');
  expect(await canUndo(app)).toBe(false);

  await fingers.tap(toolButton('block'));
  expect(await isChosen('block')).toBe('true');
  await toolsCame(app);
  const [place] = await inWindow(app, SIZE, [[700, 400]]);
  if (place !== undefined) await fingers.tapAt(place);
  await expect.poll(() => app.text(by('editor-said'))).toContain('Block added at 70 | 40 cm');
  await fingers.tap(by('undo'));
  await expect.poll(() => app.text(by('editor-said'))).toContain('Undone: Block added');
  await fingers.tap(by('redo'));
  await expect.poll(() => app.text(by('editor-said'))).toContain('Redone: Block added');
});

test('the first line is drawn even where the code of the tools is still on its way', async ({ page }) => {
  let letCome = (): void => undefined;
  const late = new Promise<void>((resolve) => (letCome = resolve));
  await page.route('**/arena-tools-*.js', async (route) => {
    await late;
    await route.continue();
  });
  const { app, fingers } = await withFingers(page);
  await openEditor(app);
  await clearAll(app);
  await fingers.tap(toolButton('pen'));
  await fingers.draw(await inWindow(app, SIZE, line([200, 450], [700, 450])));
  letCome();
  await expect.poll(() => listOf(app)).toHaveLength(2); // the robot’s start and the line
});
