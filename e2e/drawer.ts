import { stopsOf } from '../src/scene/kinds/mover-way';
import type { Point, Scene, SceneObject } from '../src/scene/scene';
import { inWindow } from './arena';
import { expect, type App } from './app';
import { openedCourse } from './opened-course';
import { isThere } from './page';
import { by, until } from './parts';
import { SIZE, toolButton, toolsCame } from './pupil';

/** Somebody who draws with the mouse and the keyboard, and whose gestures are counted. */
export interface Drawer {
  readonly app: App;
  readonly count: () => number;
  click(css: string): Promise<void>;
  clickAt(place: Point, ...held: readonly string[]): Promise<void>;
  /** Two clicks as fast as the browser's driver can. They count as two. */
  doubleClickAt(place: Point): Promise<void>;
  drag(places: readonly Point[], ...held: readonly string[]): Promise<void>;
  key(...keys: string[]): Promise<void>;
  /** Writes a number into the field that a click has chosen, and leaves it by Enter. */
  number(css: string, text: string): Promise<void>;
}

function drawer(app: App): Drawer {
  let gestures = 0;
  const use = async (places: readonly Point[], held: readonly string[]): Promise<void> => {
    gestures += 1;
    const window = await inWindow(app, SIZE, places);
    for (const key of held) await app.hold(key);
    await app.draw(window);
    for (const key of held) await app.release(key);
  };
  return {
    app,
    count: () => gestures,
    async click(css) {
      gestures += 1;
      await until(app, css);
      await app.click(css);
    },
    clickAt: (place, ...held) => use([place], held),
    async doubleClickAt(place) {
      gestures += 2;
      const window = await inWindow(app, SIZE, [place]);
      await app.draw(window);
      await app.draw(window);
    },
    drag: (places, ...held) => use(places, held),
    async key(...keys) {
      gestures += 1;
      await app.press(...keys);
    },
    async number(css, text) {
      gestures += 1;
      await until(app, css);
      await app.fill(css, text);
      await app.press('Enter');
    },
  };
}

/** A wall, a line and a fixed block to begin with. */
export const wall = (id: string, from: Point, to: Point): SceneObject => ({
  type: 'wall',
  id,
  from,
  to,
  thickness: 10,
});
export const line = (id: string, ...points: readonly Point[]): SceneObject => ({
  ...{ type: 'stroke', id, points },
  ...{ width: 20, color: 'black' },
});
export const block = (id: string, at: Point): SceneObject => ({
  type: 'fixed-block',
  id,
  at,
  size: [60, 60],
  angle: 0,
});
/** A foe that goes to and fro. */
export const foe = (at: Point, to: Point): SceneObject => ({
  ...{ type: 'mover', id: 'm', at, to, size: [60, 60], angle: 0 },
  ...{ speed: 100, spiked: false },
});

/** Opens a course with these objects, the robot out of the way, with Select chosen. */
export async function opened(app: App, ...objects: readonly SceneObject[]): Promise<Drawer> {
  await app.goto('./logo.svg');
  const work = JSON.parse(openedCourse('empty')) as { project: { scene: Scene; course: string | null } };
  const { scene } = work.project;
  Object.assign(work.project, {
    course: null,
    scene: { ...scene, size: SIZE, robot: { ...scene.robot, at: [1100, 80] }, objects, background: null },
  });
  await app.evaluate((text) => {
    localStorage.setItem('parcours.settings', JSON.stringify({ language: 'en', showTools: true }));
    sessionStorage.setItem('parcours.work', text);
  }, JSON.stringify(work));
  await app.goto('./');
  await until(app, toolButton('select'));
  await until(app, by('course-more'));
  await app.click(toolButton('select'));
  await toolsCame(app);
  return drawer(app);
}

/** The objects as the page has saved them. */
export const objectsIn = (app: App): Promise<readonly SceneObject[]> =>
  app.evaluate(() => {
    const work = JSON.parse(sessionStorage.getItem('parcours.work') ?? '{}') as {
      readonly project?: { readonly scene: Pick<Scene, 'objects'> };
    };
    return work.project?.scene.objects ?? [];
  });

/** Waits until some figures of the objects are these. */
export const comesTo = (
  app: App,
  figures: (objects: readonly SceneObject[]) => unknown,
  wanted: unknown,
): Promise<void> => expect.poll(async () => figures(await objectsIn(app)), { timeout: 10_000 }).toEqual(wanted);

/** The middles of all that have one. */
export const places = (objects: readonly SceneObject[]): unknown => objects.map((one) => ('at' in one ? one.at : null));
/** From where to where the walls go. */
export const ends = (objects: readonly SceneObject[]): unknown =>
  objects.map((one) => (one.type === 'wall' ? [one.from, one.to] : null));

/** The stops of the foes, one after the other. */
export const stops = (objects: readonly SceneObject[]): unknown =>
  objects.flatMap((one) => (one.type === 'mover' ? stopsOf(one).map(({ at }) => at) : []));

/** Chooses the n-th, from 0, of what a tool's head offers under a label, whether in a row or in a card. */
export async function chooseOption({ app }: Drawer, label: string, place: number): Promise<void> {
  const row = `[role="radiogroup"][aria-label="${label}"]`;
  if (!(await isThere(app, row))) await app.click(`.ctl.option[aria-label^="${label}"]`);
  await until(app, row);
  const choice = `${row} > [role="radio"]:nth-child(${String(place + 1)})`;
  await app.click(choice);
  // A card closes, a row shows it.
  await expect
    .poll(async () => !(await isThere(app, row)) || isThere(app, `${choice}[aria-checked="true"]`))
    .toBe(true);
}

/** Waits for figures of the objects, and that one undo brings back those of before. */
export async function isOneEdit(
  app: App,
  figures: (objects: readonly SceneObject[]) => unknown,
  before: unknown,
  after: unknown,
): Promise<void> {
  await comesTo(app, figures, after);
  await app.click(by('undo'));
  await comesTo(app, figures, before);
}
