import { nextTick } from 'vue';

import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { joinEditor } from '../../course/editor/join-editor';
import { named } from './mount-on';
import { createPage, type TestPage } from './page';

/** An object of this kind. */
type OfKind<T extends SceneObject['type']> = SceneObject & { readonly type: T };

/** A page whose course is being edited. */
export interface EditingPage extends TestPage {
  /** The course as it is now. */
  readonly scene: () => Scene;
  /** The object with this id, as its kind. */
  readonly object: <T extends SceneObject['type']>(type: T, id: string) => OfKind<T>;
  /** The ids of all objects. */
  readonly ids: () => readonly string[];
  /** Number of steps that can be taken back. */
  readonly steps: () => number;
}

/** A page with a course of one's own, of 1200 × 900 mm with these objects, and an editor that knows its limits and words. */
export async function editingPage(
  objects: readonly SceneObject[] = [],
  more: Partial<Scene> = {},
): Promise<EditingPage> {
  const page = createPage();
  page.work.setScene({ ...defaultScene(), size: [1200, 900], objects, ...more }, null);
  page.mode.enter('build');
  page.editor.choose('hand');
  await nextTick(); // another course begins with nothing selected
  joinEditor(page.editor);
  const scene = (): Scene => page.work.scene.value;
  return {
    ...page,
    scene,
    object(type, id) {
      const found = scene().objects.find((one) => one.id === id);
      if (found?.type !== type) throw new Error(`${id} is ${found?.type ?? 'gone'}, not ${type}.`);
      return found as OfKind<typeof type>;
    },
    ids: () => scene().objects.map(({ id }) => id),
    steps: () => page.work.history.value.past.length,
  };
}

/** Presses a button, menu entry or other control by its name. */
export async function press(name: string, selector?: string): Promise<void> {
  named(name, selector).click();
  await nextTick();
}

/** Writes into a field as a user does, and leaves it. */
export async function fill(name: string, text: string): Promise<void> {
  const field = named(name, 'input, textarea') as HTMLInputElement;
  field.value = text;
  field.dispatchEvent(new Event('input', { bubbles: true }));
  await nextTick();
  field.dispatchEvent(new Event('change', { bubbles: true }));
  await nextTick();
}

/** Presses a key on an element. @returns the event after the page has handled it */
export async function keyOn(target: EventTarget, key: string, more: KeyboardEventInit = {}): Promise<KeyboardEvent> {
  const event = new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...more });
  target.dispatchEvent(event);
  await nextTick();
  return event;
}

/** One of each kind, at least 100 mm from each other and from the robot's start in the middle. */
export const samples = {
  stroke: {
    type: 'stroke',
    id: 'line',
    points: [
      [100, 800],
      [300, 800],
    ],
    width: 20,
    color: 'black',
  },
  wall: { type: 'wall', id: 'wall', from: [100, 100], to: [300, 100], thickness: 10 },
  block: { type: 'block', id: 'block', at: [400, 200], size: [50, 50], angle: 0 },
  'fixed-block': { type: 'fixed-block', id: 'fixed', at: [900, 200], size: [100, 50], angle: 0 },
  spikes: { type: 'spikes', id: 'spikes', at: [1050, 200], size: [60, 60], angle: 0 },
  mover: { type: 'mover', id: 'mover', at: [900, 400], to: [1100, 400], size: [50, 50], angle: 0, speed: 100, spiked: false }, // prettier-ignore
  target: { type: 'target', id: 'target', at: [900, 700], size: [150, 150], angle: 0, round: false, number: 0, blocks: 0 }, // prettier-ignore
  checkpoint: { type: 'checkpoint', id: 'one', at: [200, 300], size: [100, 100], angle: 0, round: false, number: 1, blocks: 0 }, // prettier-ignore
  forbidden: { type: 'forbidden', id: 'forbidden', at: [200, 600], size: [100, 100], angle: 0, round: true, number: 0, blocks: 0 }, // prettier-ignore
  paper: { type: 'paper', id: 'paper', at: [200, 450], size: [100, 60], angle: 0, color: 'green' },
  lamp: { type: 'lamp', id: 'lamp', at: [700, 800], height: 260, brightness: 40 },
  barrier: { type: 'barrier', id: 'barrier', from: [1000, 300], to: [1000, 450], thickness: 10, opens: 'hand' },
  tunnel: { type: 'tunnel', id: 'tunnel', at: [350, 450], size: [120, 120], angle: 0 },
  tag: { type: 'tag', id: 'tag', at: [850, 750], number: 7, side: 60, angle: 90 },
  label: { type: 'label', id: 'label', at: [500, 800], text: 'Hallo', height: 30, angle: 0 },
  start: {
    type: 'start',
    id: 'second',
    at: [600, 150],
    heading: 90,
    robot: null,
    options: {},
    name: 'Ada',
    color: 'teal',
  },
} as const satisfies { readonly [T in SceneObject['type']]: OfKind<T> };
