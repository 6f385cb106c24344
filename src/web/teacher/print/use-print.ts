import { computed, shallowRef } from 'vue';

import { radOf } from '#core/angle';
import type { Scene } from '#scene/scene';

import { useDrawing } from '../../session/work/hardware/use-drawing';
import { useHardware } from '../../session/work/hardware/use-hardware';
import { useRun } from '../../session/run/parts';
import { checksInWords } from '../../session/task/checks-in-words';
import { useTask } from '../../session/task/parts';
import { useWork } from '../../session/work/model/parts';
import { courseName } from '../../session/work/catalogue/first-course';
import { t } from '../../kit/i18n';
import { coursePng, piecesOf, pictureAddress } from './picture-parts';
import { fileName, saveBlob } from '../../session/work/save-file';
import { courseSvg, type PictureOptions } from './svg-course';
import words from './words';
import runWords from './run/words';
import type { PaperTask } from './task/task-blocks';
import { taskOnPaper } from './task-on-paper';

/** Longer sides of the pictures in pixels: twice a screen's arena, and fine enough for a page of A4. */
export const PNG_PX = { usual: 1800, large: 4000 } as const;

/** The options of a picture. */
export type PictureWish = Readonly<Record<'grid' | 'rulers' | 'robot' | 'path' | 'task', boolean>>;

/**
 * Makes files of the open course and offers them as downloads, one at a time; says whether that worked.
 *
 * @param other another course, whose name is its own; without robot, path and task
 */
export function usePrint(other: Scene | null = null) {
  const app = { ...useRun(), ...useWork() };
  const { task } = useTask();
  const hardware = useHardware(app);
  const scene = computed(() => other ?? app.work.scene.value);
  const name = computed(() => other?.name ?? courseName(scene.value, app.work.work.value.project.course));
  const robot = computed(() => (other === null ? (hardware.value?.robot ?? null) : null));
  const drawing = useDrawing(() => robot.value);
  const { isBusy, said, save } = useSaving(() => name.value);
  const pieces = computed(() =>
    other !== null || app.run.snapshot.value === null ? [] : piecesOf(app.run.trails.first),
  );

  function optionsFor(wish: PictureWish): PictureOptions {
    const { at, heading, scale } = scene.value.robot;
    const pose = { xMm: at[0], yMm: at[1], headingRad: radOf(heading) };
    return {
      grid: wish.grid,
      rulers: wish.rulers,
      robot: wish.robot && drawing.value !== null ? { pose, scale, drawing: drawing.value } : null,
      path: wish.path ? pieces.value : [],
      background: scene.value.background === null ? null : pictureAddress(scene.value.background),
      floor: true,
      task: wish.task && task.hasText.value ? task.text.value : null,
    };
  }

  return {
    scene,
    name,
    isBusy,
    said,
    hasRobot: computed(() => robot.value !== null),
    hasPath: computed(() => pieces.value.length > 0),
    hasTask: computed(() => other === null && task.hasText.value),
    hasHints: computed(() => task.text.value.hints.length > 0),
    /** The task as it is printed, with the hints only on request. */
    paperTask: (withHints: boolean): Promise<PaperTask> =>
      taskOnPaper(scene.value, task.text.value, checksInWords(app.work.work.value.project), withHints),
    optionsFor,
    svg: (wish: PictureWish): string => courseSvg(scene.value, optionsFor(wish)).svg,
    savePng: (wish: PictureWish, longestPx: number) =>
      save('png', () => coursePng(scene.value, optionsFor(wish), longestPx)),
    saveSvg: (wish: PictureWish) =>
      save('svg', () => Promise.resolve(new Blob([courseSvg(scene.value, optionsFor(wish)).svg], { type: SVG_TYPE }))),
    savePdf: (make: (scene: Scene, name: string) => Promise<Blob>) => save('pdf', () => make(scene.value, name.value)),
    /** Saves a file made of the run. @param signal gives it up: then it is no failure */
    saveRun: (ending: string, make: (name: string) => Promise<Blob>, signal?: AbortSignal) =>
      save(`run.${ending}`, () => make(name.value), signal),
  };
}

/** Saves files one at a time, and says how that goes. @param name under which they are saved */
function useSaving(name: () => string) {
  const isBusy = shallowRef(false);
  const said = shallowRef<{ readonly text: string; readonly isError: boolean } | null>(null);

  /** Makes a file and saves it under that name. */
  async function save(ending: string, make: () => Promise<Blob>, signal?: AbortSignal): Promise<void> {
    if (isBusy.value) return;
    isBusy.value = true;
    said.value = { text: t(words.working), isError: false };
    await new Promise((resolve) => setTimeout(resolve, 30)); // the message must be on screen before the work begins
    try {
      const file = fileName(name(), ending);
      saveBlob(file, await make());
      said.value = { text: t('files.saved', { file }), isError: false };
    } catch {
      const isGivenUp = signal?.aborted === true;
      said.value = { text: t(isGivenUp ? runWords.givenUp : words.failed), isError: !isGivenUp };
    }
    isBusy.value = false;
  }
  return { isBusy, said, save };
}

const SVG_TYPE = 'image/svg+xml';

/** The result of `usePrint`. */
export type Print = ReturnType<typeof usePrint>;
