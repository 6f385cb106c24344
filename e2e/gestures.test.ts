import type { Point, SceneObject } from '../src/scene/scene';
import { inWindow } from './arena';
import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { block, chooseOption, comesTo, foe, isOneEdit, line, objectsIn, opened, places, stops } from './drawer';
import { by, gone, until } from './parts';
import { SIZE, toolButton } from './pupil';

/*
 * One gesture of the course editor a test, one of each sort in all three engines: what it does is one edit, and one undo takes it back.
 */

const sizes = (objects: readonly SceneObject[]): unknown => objects.map((one) => ('size' in one ? one.size : null));
const angles = (objects: readonly SceneObject[]): unknown => objects.map((one) => ('angle' in one ? one.angle : 0));
/** Large enough that its handles lie on its own sides. */
const large = (at: Point): SceneObject => ({ type: 'fixed-block', id: 'a', at, size: [200, 200], angle: 0 });
const count = (objects: readonly SceneObject[]): unknown => objects.length;

test('a side’s handle sizes a block, a corner’s two of its sides', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, large([400, 400]));
  await hand.clickAt([400, 400]);
  await until(app, by('remove'));
  await hand.drag([[500, 400], [550, 400], [600, 400]]); // prettier-ignore
  await isOneEdit(app, sizes, [[200, 200]], [[300, 200]]);
  await hand.drag([[500, 500], [520, 550], [560, 600]]); // prettier-ignore
  await isOneEdit(app, sizes, [[200, 200]], [[260, 300]]);
});

test('a lasso catches what its line meets, and all of it moves together', async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]), block('c', [700, 200]));
  await chooseOption(hand, 'What catches objects on the floor', 1);
  await hand.drag([[100, 100], [100, 300], [350, 600], [500, 600], [480, 420], [300, 100]]); // prettier-ignore
  await until(app, by('remove'));
  await hand.drag([[200, 200], [200, 250], [200, 300]]); // prettier-ignore
  await isOneEdit(app, places, [[200, 200], [400, 500], [700, 200]], [[200, 300], [400, 600], [700, 200]]); // prettier-ignore
});

test('where several are chosen, a click adds or takes away', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]), block('c', [700, 200]));
  await hand.click(by('several'));
  for (const at of [
    [200, 200],
    [400, 500],
    [700, 200],
    [400, 500],
  ] as const)
    await hand.clickAt(at);
  await hand.key('Delete');
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

test('a right click opens the menu of a thing: it is locked there, caught by nothing, and unlocked', async ({
  app,
}) => {
  test.skip(app.engine === 'webkit', 'the driver of WebKitGTK tells of no pointer that lets the right button go');
  const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]));
  const rightClick = async (at: Point): Promise<void> => app.draw(await inWindow(app, SIZE, [at]), 'right');
  await rightClick([200, 200]);
  await hand.click(by('menu-lock'));
  await comesTo(app, (all) => all.map(({ lock }) => lock ?? false), [true, false]);
  await hand.key('Escape');
  await hand.drag([[200, 200], [250, 250], [300, 300]]); // prettier-ignore
  await hand.key('Control', 'a');
  await until(app, by('remove'));
  await hand.key('Delete');
  await comesTo(app, (all) => all.map(({ id }) => id), ['a']);
  expect(places(await objectsIn(app))).toEqual([[200, 200]]);
  await rightClick([200, 200]);
  await hand.click(by('menu-unlock'));
  await isOneEdit(app, (all) => all.map(({ lock }) => lock ?? false), [true], [false]);
});

test('a group is one for a click, and one of it is moved after a double click', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]));
  await hand.key('Control', 'a');
  await until(app, by('remove'));
  await hand.key('Control', 'g');
  await comesTo(app, (all) => all.map(({ group }) => group !== undefined), [true, true]);
  await hand.clickAt([900, 800]);
  await gone(app, by('remove'));
  await hand.drag([[200, 200], [250, 200], [300, 200]]); // prettier-ignore
  await isOneEdit(app, places, [[200, 200], [400, 500]], [[300, 200], [500, 500]]); // prettier-ignore
  await hand.clickAt([900, 800]);
  await gone(app, by('remove'));
  await hand.doubleClickAt([200, 200]);
  await hand.drag([[200, 200], [250, 200], [300, 200]]); // prettier-ignore
  await isOneEdit(app, places, [[200, 200], [400, 500]], [[300, 200], [400, 500]]); // prettier-ignore
});

test('a block goes to the grid, but not while Ctrl is held, nor without the magnet', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [400, 400]));
  const byHand: readonly Point[] = [[400, 400], [450, 400], [503, 403]]; // prettier-ignore
  await hand.drag(byHand);
  await isOneEdit(app, places, [[400, 400]], [[500, 400]]);
  await hand.click(by('magnet'));
  await hand.drag(byHand);
  await comesTo(app, (all) => Math.abs(((places(all) as Point[])[0]?.[0] ?? 0) - 503) <= 2, true);
});

for (const [name, place, gesture, wanted] of [
  ['a straight line', 2, [[200, 200], [300, 300], [500, 202]], 2], // prettier-ignore
  ['a circle', 5, [[200, 200], [300, 300], [400, 400]], 9], // prettier-ignore
  ['an oval', 6, [[200, 200], [300, 300], [600, 400]], 9], // prettier-ignore
  ['a rounded rectangle', 7, [[200, 200], [300, 300], [600, 400]], 9], // prettier-ignore
] as const)
  test(`${name} is drawn by one drag`, IN_ONE_ENGINE, async ({ app }) => {
    const hand = await opened(app);
    await hand.click(toolButton('pen'));
    await chooseOption(hand, 'Shape', place);
    await hand.drag(gesture);
    const pointsOf = (all: readonly SceneObject[]): number => (all[0]?.type === 'stroke' ? all[0].points.length : 0);
    await isOneEdit(app, (all) => pointsOf(all) >= wanted, false, true);
  });

test(
  'a line from click to click ends with a click on its last corner, an arc with its third place',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const hand = await opened(app);
    await hand.click(toolButton('pen'));
    await chooseOption(hand, 'Shape', 3);
    for (const at of [
      [200, 200],
      [500, 200],
      [500, 500],
      [500, 500],
    ] as const)
      await hand.clickAt(at);
    await isOneEdit(app, (all) => all.map((one) => ('points' in one ? one.points : [])), [], [[[200, 200], [500, 200], [500, 500]]]); // prettier-ignore
    await chooseOption(hand, 'Shape', 4);
    for (const at of [
      [200, 200],
      [600, 200],
      [400, 400],
    ] as const)
      await hand.clickAt(at);
    await isOneEdit(app, count, 0, 1);
  },
);

test('a polygon is set corner by corner, and closed by a click on its first', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app);
  await hand.click(toolButton('block'));
  await chooseOption(hand, 'Shape', 2);
  for (const at of [
    [200, 200],
    [400, 200],
    [400, 400],
    [300, 500],
    [200, 200],
  ] as const)
    await hand.clickAt(at);
  await isOneEdit(app, (all) => all.map((one) => ('corners' in one ? (one.corners?.length ?? 0) : 0)), [], [4]);
});

test('what is copied in one window is pasted in another', async ({ app, another }) => {
  const hand = await opened(app, block('a', [200, 200]), block('b', [400, 500]));
  await hand.key('Control', 'a');
  await until(app, by('remove'));
  await app.evaluate(() => {
    addEventListener('copy', ({ clipboardData }) => (document.title = clipboardData?.getData('text/plain') ?? ''));
  });
  await hand.key('Control', 'c');
  await expect.poll(() => app.evaluate(() => document.title)).toContain('"at"');
  const text = await app.evaluate(() => document.title);
  const other = await another();
  await opened(other, block('x', [800, 100]));
  // Browsers of tests share no clipboard: the text goes over by hand, as the browser's own paste event.
  await other.evaluate((clip) => {
    const data = new DataTransfer();
    data.setData('text/plain', clip);
    // Firefox takes the text by two names of its own.
    const own = { dataType: 'text/plain', data: clip };
    document.dispatchEvent(
      new ClipboardEvent('paste', {
        ...own,
        clipboardData: data,
        bubbles: true,
        cancelable: true,
      }),
    );
  }, text);
  await comesTo(other, count, 3);
});

test('the knob turns a block by 15° steps', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, large([400, 400]));
  await hand.clickAt([400, 400]);
  await until(app, by('remove'));
  const [middle, top] = await inWindow(app, SIZE, [[400, 400], [400, 500]]); // prettier-ignore
  if (middle === undefined || top === undefined) throw new Error('There is no block.');
  // It stands 16 px above the block.
  const knob = { x: top.x, y: top.y - 16 };
  // A little beside 45° is 45°.
  await app.draw([knob, { x: knob.x + 40, y: knob.y }, { x: middle.x + 90, y: middle.y - 84 }]);
  await isOneEdit(app, angles, [0], [315]);
});

test('the points of a line are moved after a double click', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, line('s', [200, 200], [500, 200], [500, 500]));
  await hand.doubleClickAt([300, 200]);
  await until(app, by('points-done'));
  await hand.drag([[500, 200], [550, 200], [600, 200]]); // prettier-ignore
  const points = (all: readonly SceneObject[]): unknown => all.map((one) => ('points' in one ? one.points : null));
  const before = [[[200, 200], [500, 200], [500, 500]]]; // prettier-ignore
  await isOneEdit(app, points, before, [[[200, 200], [600, 200], [500, 500]]]); // prettier-ignore
});

test(
  'a corner of a finished polygon is dragged after a double click, and one is drawn out of an edge',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const three: SceneObject = { ...large([400, 400]), corners: [[0, 0], [200, 0], [0, 200]] } as SceneObject; // prettier-ignore
    const hand = await opened(app, three);
    const corners = (all: readonly SceneObject[]): unknown => all.map((one) => ('corners' in one ? one.corners : null));
    const before = [[[0, 0], [200, 0], [0, 200]]]; // prettier-ignore
    await hand.doubleClickAt([350, 350]);
    await until(app, by('points-done'));
    await hand.drag([[500, 300], [550, 300], [600, 300]]); // prettier-ignore
    await isOneEdit(app, corners, before, [[[0, 0], [300, 0], [0, 200]]]); // prettier-ignore
    await hand.drag([[400, 300], [400, 250], [400, 200]]); // prettier-ignore
    await isOneEdit(app, corners, before, [[[0, 100], [100, 0], [200, 100], [0, 300]]]); // prettier-ignore
  },
);

test(
  'a foe gets a further stop from the middle of its way, and loses it on a neighbour',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const two = [[200, 300], [600, 300]]; // prettier-ignore
    const hand = await opened(app, foe([200, 300], [600, 300]));
    await hand.clickAt([200, 300]);
    await until(app, by('remove'));
    await hand.drag([[400, 300], [400, 400], [400, 500]]); // prettier-ignore
    await isOneEdit(app, stops, two, [[200, 300], [400, 500], [600, 300]]); // prettier-ignore
    await app.click(by('redo'));
    await hand.drag([[400, 500], [300, 400], [202, 302]]); // prettier-ignore
    await comesTo(app, stops, two);
  },
);
