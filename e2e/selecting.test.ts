import { test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { block, comesTo, opened, places } from './drawer';
import { by, gone, until } from './parts';

test('Shift adds to what is selected, and all of it moves together', async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]), block('c', [700, 700]));
  await hand.clickAt([200, 200]);
  await hand.clickAt([400, 500], 'Shift');
  await hand.drag([[200, 200], [200, 250], [200, 300]]); // prettier-ignore
  await comesTo(app, places, [[200, 300], [400, 600], [700, 700]]); // prettier-ignore
});

test(
  'a frame from the floor catches what it touches; Delete takes that away, and one undo brings it back',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]), block('c', [700, 700]));
    await hand.drag([[100, 100], [300, 400], [500, 600]]); // prettier-ignore
    await until(app, by('remove'));
    await hand.key('Delete');
    await comesTo(app, places, [[700, 700]]); // prettier-ignore
    await app.click(by('undo'));
    await comesTo(app, places, [[200, 200], [400, 500], [700, 700]]); // prettier-ignore
  },
);

test('Alt-drag copies, and Ctrl+D goes on by the same step', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]));
  await hand.drag([[200, 200], [300, 200], [400, 200]], 'Alt'); // prettier-ignore
  await comesTo(app, places, [[200, 200], [400, 200]]); // prettier-ignore
  await hand.key('Control', 'd');
  await comesTo(app, places, [[200, 200], [400, 200], [600, 200]]); // prettier-ignore
});

test('while text of the page is selected, a drag still moves what lies in the arena', async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]));
  await app.evaluate(() => getSelection()?.selectAllChildren(document.body));
  await hand.drag([[200, 200], [200, 250], [200, 300]]); // prettier-ignore
  await comesTo(app, places, [[200, 300]]); // prettier-ignore
});

test('Escape lets go of what is selected', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]));
  await hand.clickAt([200, 200]);
  await until(app, by('remove'));
  await hand.key('Escape');
  await gone(app, by('remove'));
});

test(
  'a part of the shelf is inserted in the middle by a click, and taken back by one undo',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const hand = await opened(app);
    await hand.click(by('course-more'));
    await hand.click(by('editor-parts'));
    await hand.click(by('part-gate'));
    await comesTo(app, places, [[490, 450], [710, 450]]); // prettier-ignore
    await hand.click(by('close-parts'));
    await gone(app, by('parts-shelf'));
    await app.click(by('undo'));
    await comesTo(app, places, []);
  },
);
