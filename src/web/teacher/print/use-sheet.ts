import { computed, shallowRef, watch, type Ref } from 'vue';

import { isSame } from '#core/same';
import { creditOf, noAbout } from '#check/task/about';
import { draftOf } from '#check/task/read-task';
import { withoutSecrets } from '#check/task/write-task';

import { t } from '../../kit/i18n';
import { presentProject } from '../../session/work/save-work';
import { useShareLink } from '../../exchange/share/use-share-link';
import { useWork } from '../../session/work/model/parts';
import { coursePng } from './picture-parts';
import { courseSvg, type PictureOptions } from './svg-course';
import type { PaperTask } from './task/task-blocks';
import type { Print } from './use-print';
import { PAPER_QR_CHARACTERS, paperQr } from './sheet/paper-qr';
import { layOutSheet, SIDE_MM, type SheetContent, type Space } from './sheet/sheet-layout';
import words from './sheet/words';
import { sheetSvgs } from './sheet/svg-sheet';
import { svgAddress } from './svg-address';

/** The teacher's wishes for the sheet. */
export interface SheetWish {
  readonly qr: boolean;
  readonly hints: boolean;
  readonly space: Space;
}

/** Dots of the drawing for each mm of paper: 300 an inch. */
const DOTS_PER_MM = 300 / 25.4;

const cm = (mm: number): string => String(Math.round(mm) / 10);

/** The worksheet of the open course: what is on it, how it looks, and its PDF. */
export function useSheet(print: Print) {
  const wish = shallowRef<SheetWish>({ qr: true, hints: false, space: 'some' });
  const code = useCode(() => wish.value.qr);
  const task = shallowRef<PaperTask | null>(null);
  let turn = 0;
  // The task's picture takes a moment; what is asked for meanwhile counts.
  async function fetchTask(): Promise<void> {
    turn += 1;
    const mine = turn;
    const made = await print.paperTask(wish.value.hints);
    if (mine === turn) task.value = made.title === '' ? { ...made, title: print.name.value } : made;
  }
  watch([() => wish.value.hints, print.scene], () => void fetchTask(), { immediate: true });

  const content = computed(
    (): SheetContent | null => task.value && contentOf(task.value, print, code.qr.value, wish, code.credit.value),
  );
  const options = (scale: number): PictureOptions => ({
    ...print.optionsFor({ grid: true, rulers: false, robot: true, path: false, task: false }),
    leastTypeMm: SIDE_MM * scale,
  });
  const pages = computed(() => {
    const now = content.value;
    if (now === null) return [];
    const layout = layOutSheet(now);
    return sheetSvgs(now, layout, courseSvg(print.scene.value, options(layout.course.scale)).svg).map(svgAddress);
  });

  async function pdf(): Promise<Blob> {
    const { sheetPdf } = await import('./sheet/pdf-sheet');
    await fetchTask();
    const now = content.value;
    if (now === null) throw new Error('no task');
    const { scene, name } = print;
    const made = await sheetPdf(now, {
      title: now.task.title || name.value,
      drawing: async (scale, longestMm) =>
        bytesOf(await coursePng(scene.value, options(scale), Math.round(longestMm * DOTS_PER_MM))),
      link: code.link.value,
    });
    return made.output('blob');
  }
  return { wish, pages, code, save: () => print.savePdf(pdf) };
}

const contentOf = (
  task: PaperTask,
  { scene }: Pick<Print, 'scene'>,
  qr: SheetContent['qr'],
  wish: Readonly<Ref<SheetWish>>,
  credit: string,
): SheetContent => ({
  task,
  credit,
  courseMm: scene.value.size,
  qr,
  space: wish.value.space,
  words: {
    name: t(words.name),
    class: t(words.class),
    date: t(words.date),
    open: t(words.open),
    questions: [t(words.plan), t(words.seen)],
    scale: (scale) =>
      t(words.scale, { width: cm(scene.value.size[0]), height: cm(scene.value.size[1]), scale: String(scale) }),
  },
});

/**
 * The code that opens the task as pupils get it, without the stored solution and hidden worlds. The program in it may
 * still be the solution: see `tellsSolution`.
 */
function useCode(isWanted: () => boolean) {
  const app = useWork();
  const present = computed(() => presentProject(app));
  const { program, link, omitted } = useShareLink(() => withoutSecrets(present.value));
  const task = computed(() => {
    const read = present.value.task === undefined ? null : draftOf(present.value);
    return read !== null && 'task' in read ? read.task : null;
  });
  const isSolution = computed(() => isSame(task.value?.solution ?? null, present.value.files));
  // The program of a task is what pupils begin with. Elsewhere it may be the teacher's own solution.
  program.value = present.value.task !== undefined && !isSolution.value;
  const made = computed(() => (link.value === null || !isAddress(link.value) ? null : paperQr(link.value)));
  const why = computed(() => whyNone(link.value, omitted.value.length > 0, made.value !== null));
  const qr = computed(() => (isWanted() && why.value === '' ? made.value : null));
  return {
    program,
    qr,
    /** Author and licence of the task; empty: none are said. */
    credit: computed(() => creditOf(task.value?.about ?? noAbout)),
    link: computed(() => (qr.value === null ? null : link.value)),
    /** The reason why there is no code, and the way out; empty: there is one, or none is wanted. */
    why: computed(() => (isWanted() ? why.value : '')),
    /** True if the link gives away the solution. */
    tellsSolution: computed(() => qr.value !== null && program.value && isSolution.value),
  };
}

/** True if other devices can open the link. */
const isAddress = (link: string): boolean => /^https?:/.test(link);

function whyNone(link: string | null, isLeftOut: boolean, isReadable: boolean): string {
  if (link === null) return t(words.tooLarge);
  if (!isAddress(link)) return t(words.noAddress);
  if (isLeftOut) return t(words.leftOut);
  return isReadable ? '' : t(words.tooLong, { count: link.length, max: PAPER_QR_CHARACTERS });
}

const bytesOf = async (blob: Blob): Promise<Uint8Array> => new Uint8Array(await blob.arrayBuffer());
