import type { Point, SceneObject } from '../src/scene/scene';
import { inWindow } from './arena';
import { expect, warmTest as test } from './app';
import { block, chooseOption, comesTo, foe, isOneEdit, objectsIn, opened, places, stops, type Drawer } from './drawer';
import { by, until } from './parts';
import { SIZE, toolButton } from './pupil';
import { tablet, withFingers } from './touch';

/* The gestures of the course editor that fingers have in their own way, on a tablet held upright. */

test.use(tablet);

/** Places that a finger reports while it rests for the menu: 0.8 s. */
const RESTING = 50;

async function begun(page: Parameters<typeof withFingers>[0], ...objects: readonly SceneObject[]) {
  const { app, fingers } = await withFingers(page);
  const hand: Drawer = await opened(app, ...objects);
  const rest = async (at: Point): Promise<void> => {
    const [place] = await inWindow(app, SIZE, [at]);
    if (place !== undefined) await fingers.draw(Array.from({ length: RESTING }, () => place));
  };
  return { app, hand, rest };
}

test('with fingers: where several are chosen, a tap adds or takes away, and the bin takes them', async ({ page }) => {
  const { app, hand } = await begun(page, block('a', [200, 200]), block('b', [400, 500]), block('c', [700, 200]));
  await hand.click(by('several'));
  for (const at of [
    [200, 200],
    [400, 500],
    [700, 200],
    [400, 500],
  ] as const)
    await hand.clickAt(at);
  await hand.click(by('remove'));
  await isOneEdit(
    app,
    places,
    [
      [200, 200],
      [400, 500],
      [700, 200],
    ],
    [[400, 500]],
  );
});

test('with fingers: a long press opens the menu; what is locked stays, until it is unlocked there', async ({
  page,
}) => {
  const { app, hand, rest } = await begun(page, block('a', [200, 200]), block('b', [400, 500]));
  const locks = (all: readonly SceneObject[]): unknown => all.map(({ lock }) => lock ?? false);
  await rest([200, 200]);
  await hand.click(by('menu-lock'));
  await comesTo(app, locks, [true, false]);
  await hand.drag([[200, 200], [250, 250], [300, 300]]); // prettier-ignore
  expect(places(await objectsIn(app))).toEqual([[200, 200], [400, 500]]); // prettier-ignore
  await rest([200, 200]);
  await hand.click(by('menu-unlock'));
  await isOneEdit(app, locks, [true, false], [false, false]);
});

test('with fingers: a handle sizes, and the magnet can be switched off', async ({ page }) => {
  const large: SceneObject = { type: 'fixed-block', id: 'a', at: [500, 400], size: [300, 300], angle: 0 };
  const { app, hand } = await begun(page, large);
  const widths = (all: readonly SceneObject[]): number => Math.round((all[0] as typeof large).size[0] ?? 0);
  await hand.clickAt([500, 400]);
  await until(app, by('remove'));
  await hand.drag([[650, 550], [700, 580], [752, 601]]); // prettier-ignore
  await isOneEdit(app, widths, 300, 400);
  await hand.click(by('magnet'));
  await hand.drag([[650, 550], [700, 580], [754, 603]]); // prettier-ignore
  await comesTo(app, (all) => Math.abs(widths(all) - 404) <= 3 && widths(all) !== 400, true);
});

test('with fingers: a circle is drawn by a drag, a polygon by taps on its corners', async ({ page }) => {
  const { app, hand } = await begun(page);
  await hand.click(toolButton('pen'));
  await chooseOption(hand, 'Shape', 5);
  await hand.drag([[200, 200], [300, 300], [400, 400]]); // prettier-ignore
  await isOneEdit(app, (all) => all.length, 0, 1);
  await hand.click(toolButton('block'));
  await chooseOption(hand, 'Shape', 2);
  for (const at of [
    [200, 200],
    [500, 200],
    [500, 500],
    [200, 200],
  ] as const)
    await hand.clickAt(at);
  await isOneEdit(app, (all) => all.map((one) => ('corners' in one ? (one.corners?.length ?? 0) : 0)), [], [3]);
});

test('with fingers: a foe gets a further stop from the middle of its way, and loses it on a neighbour', async ({
  page,
}) => {
  const { app, hand } = await begun(page, foe([200, 300], [700, 300]));
  await hand.clickAt([200, 300]);
  await until(app, by('remove'));
  await hand.drag([[450, 300], [450, 400], [450, 550]]); // prettier-ignore
  await isOneEdit(app, stops, [[200, 300], [700, 300]], [[200, 300], [450, 550], [700, 300]]); // prettier-ignore
  await app.click(by('redo'));
  await hand.drag([[450, 550], [600, 400], [698, 302]]); // prettier-ignore
  await comesTo(app, stops, [[200, 300], [700, 300]]); // prettier-ignore
});
