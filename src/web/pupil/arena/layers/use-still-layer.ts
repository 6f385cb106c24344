import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import type { Vec } from '#core/geometry';
import { isField } from '#scene/kinds/zone';
import type { RobotStart, Scene, SceneObject } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';
import { drawScene, type PaintObjects } from '../picture/draw-scene';
import type { LiveScene } from '../picture/live-scene';
import { useViewRest } from '../picture/kept-picture';
import { wholeCanvas } from '../view/moving-window';
import type { Palette } from '../model/palette';
import type { SceneKinds } from '../picture/scene-kinds';
import { areMany, createStillCache, type StillFrame } from '../picture/still-cache';
import { useLayer } from '../view/use-layer';
import type { ArenaView } from '../view/use-arena-view';

/** Everything that the still layer shows. */
export interface StillSources {
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  readonly picture: ArenaView;
  readonly palette: () => Palette;
  readonly live: () => LiveScene;
  /** Start of the robot, if it is elsewhere now. */
  readonly start: () => RobotStart | null;
  /** Convex parts of the robot at scale 1 in its own frame, mm. */
  readonly footprint: () => readonly (readonly Vec[])[];
  /** Ids of objects that are shown elsewhere: a tool has them. */
  readonly hidden: () => ReadonlySet<string>;
  readonly newest: () => Snapshot | null;
}

/** The layer of everything that does not move. */
export interface StillLayer {
  readonly draw: () => void;
  /** The drawing of obstacles, words and the background, once a course has needed it. */
  readonly kinds: Readonly<ShallowRef<SceneKinds | null>>;
}

/**
 * Redraws everything that does not move when it changes; loads the drawing code of rarer things when a course has any.
 */
export function useStillLayer(sources: StillSources): StillLayer {
  const { picture } = sources;
  const ratio = (): number => picture.ratio.value;
  const zones = useLate(
    () => sources.live().scene.objects.some(isField),
    () => import('../picture/draw-zones'),
  );
  const sheets = useLate(
    () => sources.live().scene.objects.some(({ type }) => type === 'paper'),
    () => import('../picture/sheets'),
  );
  const kinds = useLate(
    () => needsKinds(sources.live()) || sources.start() !== null,
    () => import('../picture/scene-kinds').then(({ createSceneKinds }) => createSceneKinds(() => draw())),
  );
  const keep = useKeptPicture(() => draw());
  const all = computed(() => withoutHidden(sources.live().scene, sources.hidden()));
  const shown = computed(() => kinds.value?.inRun(all.value, sources.newest()) ?? all.value);
  const verdict = (): Verdict | null => sources.newest()?.verdict ?? null;
  const progress = computed(() => progressOf(verdict()));
  const draw = useLayer({
    canvas: sources.canvas,
    ratio,
    place: () => wholeCanvas(picture.canvas.value),
    paint(context) {
      const view = picture.view.value;
      const palette = sources.palette();
      const frame = { view, canvas: picture.canvas.value, ratio: ratio(), palette, look: kinds.value };
      const drawing = { zones: zones.value, sheets: sheets.value, kinds: kinds.value };
      const still = { scene: shown.value, ...drawing, verdict: verdict() };
      drawScene(context, view, still, picture.canvas.value, palette, keep(frame, shown.value.objects));
      const waiting = { live: sources.live(), start: sources.start(), footprint: sources.footprint(), ratio: ratio() };
      kinds.value?.waiting(context, view, waiting, palette);
    },
  });
  const frame = () => [picture.view.value, picture.canvas.value, picture.ratio.value, sources.palette()];
  const code = () => [zones.value, sheets.value, kinds.value];
  const look = () => [shown.value, sources.live(), sources.start(), sources.footprint(), progress.value, code()];
  watch([frame, look], draw, { flush: 'post' });
  return { draw, kinds };
}

/** The parts of a verdict shown in the picture: as text, which is equal as long as they are. */
function progressOf(verdict: Verdict | null): string {
  if (verdict === null) return '';
  const { checkpoints, targets, blocks } = verdict;
  return [checkpoints.passed, targets.reached, blocks.delivered].join();
}

function withoutHidden(scene: Scene, hidden: ReadonlySet<string>): Scene {
  return hidden.size === 0 ? scene : { ...scene, objects: scene.objects.filter(({ id }) => !hidden.has(id)) };
}

/** True if a course has anything that `scene-kinds.ts` draws. */
const needsKinds = ({ scene, waiting, leaving, size }: LiveScene): boolean =>
  size !== null || scene.background !== null || waiting.length + leaving.size > 0 || scene.objects.some(isRare);

const COMMON: readonly SceneObject['type'][] = ['stroke', 'wall', 'block', 'fixed-block'];
const isRare = (object: SceneObject): boolean => !COMMON.includes(object.type) && !isField(object);

/** Drawing code that is loaded when it is first needed. */
function useLate<T extends object>(needed: () => boolean, load: () => Promise<T>): ShallowRef<T | null> {
  const late: ShallowRef<T | null> = shallowRef(null);
  const isNeeded: ComputedRef<boolean> = computed(needed);
  const fetch = (): void => {
    load().then(
      (loaded) => (late.value ??= loaded),
      () => undefined, // no connection at the moment: fetched with the next course
    );
  };
  watch(isNeeded, (is) => is && late.value === null && fetch(), { immediate: true });
  return late;
}

/** Caches pictures of many lines and walls while the view moves; sharpens them when it rests. */
function useKeptPicture(redraw: () => void) {
  const caches = { lines: createStillCache<SceneObject>(), standing: createStillCache<SceneObject>() };
  const rest = useViewRest(redraw);
  return (frame: StillFrame, objects: readonly SceneObject[]): PaintObjects | undefined => {
    if (!areMany(objects)) return undefined;
    const settled = rest.settled(frame);
    return (context, paint, layer) => {
      if (!caches[layer].draw(context, frame, objects, paint, settled)) rest.sharpenSoon();
    };
  };
}
