import { inWindow } from './arena';
import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { by, until } from './parts';
import { clearAll, listOf, openEditor, SIZE, toolButton, toolsCame, withMouse } from './pupil';
import { withKeys } from './keys';

/** The tools' announcements to screen readers. */
const SAID = by('arena-said');

test('by keyboard: a wall is made exactly 25 cm long by typing it', IN_ONE_ENGINE, async ({ app }) => {
  const pupil = withKeys(app);
  await openEditor(app);
  await clearAll(app);
  await pupil.chooseTool('wall');
  await pupil.draw([[300, 300], [400, 300]]); // prettier-ignore
  await app.strike(['ArrowUp', 'ArrowUp', 'ArrowUp', 'Enter', 'ArrowRight', 'ArrowRight', '2', '5']);
  await expect.poll(() => app.text(SAID)).toBe('25');
  await app.press('Enter');
  await expect.poll(() => app.text(SAID)).toContain('Length 25.0 cm');
  expect(await listOf(app)).toHaveLength(3); // with the robot's start
});

test(
  'with the mouse: what is drawn says how long it is, and snaps to what is there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const pupil = withMouse(app);
    await openEditor(app);
    await clearAll(app);
    await app.click(toolButton('wall'));
    await toolsCame(app);
    await pupil.draw([[303, 304], [420, 300], [498, 303]]); // prettier-ignore
    await until(app, SAID);
    await expect.poll(() => app.text(SAID)).toContain('Length 20.0 cm, direction 0°');
    await app.draw(await inWindow(app, SIZE, [[700, 600], [600, 602], [504, 603]])); // prettier-ignore
    await expect.poll(() => app.text(SAID)).toContain('Length 20.0 cm, direction 180°');
  },
);
