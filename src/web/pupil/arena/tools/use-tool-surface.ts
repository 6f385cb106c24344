import { computed, onBeforeUnmount, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import type { Vec } from '#core/geometry';
import type { CourseEditorModel } from '../../../course/editor/state/course-editor-model';
import type { ArenaTools, ToolSources } from './arena-tools';
import { createEarlyPointers, type EarlyPointers, type GestureEvent } from './early-pointers';
import { isSameGhost, noGhost, type HeldParts } from './ghost';
import { useLayer } from '../view/use-layer';
import type { ArenaHand } from '../hand/use-arena-hand';

/** The parts of the arena that the tools' layer uses. */
export interface ToolSurfaceSources extends Omit<ToolSources, 'editor' | 'inkCanvas' | 'redraw' | 'showGhost' | 'say'> {
  readonly editor: CourseEditorModel | null;
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  readonly ink: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  readonly hand: ArenaHand;
  /** Receives the parts of the course that are shown elsewhere. */
  readonly ghost: ShallowRef<HeldParts>;
}

/** The tools over the arena, as soon as their code is loaded. */
export interface ToolLayer {
  /** True if a tool other than the hand is chosen. */
  readonly isUsed: ComputedRef<boolean>;
  readonly cursor: Readonly<ShallowRef<string>>;
  /** Text to announce to screen readers. */
  readonly said: Readonly<ShallowRef<string>>;
  /** Place of the keyboard's crosshair, world mm, while a tool shows it. */
  readonly crosshair: () => Vec | null;
  /** Zooms in on the selection. */
  readonly showSelected: () => void;
  readonly on: ArenaHand['on'];
}

/** Passes events to the chosen tool, or to the hand; draws the tool's picture on a layer of its own. */
export function useToolSurface(sources: ToolSurfaceSources): ToolLayer {
  const { editor, picture, hand, ghost } = sources;
  const tools = shallowRef<ArenaTools | null>(null);
  const said = shallowRef('');
  const cursor = shallowRef('progress');
  const isUsed = computed(() => editor !== null && editor.tool.value !== 'hand');
  const draw = useLayer({
    canvas: sources.canvas,
    ratio: () => picture.ratio.value,
    place() {
      const box = tools.value?.place() ?? { left: 0, top: 0, width: 0, height: 0 };
      cursor.value = tools.value?.cursor() ?? 'progress';
      return box;
    },
    paint: (context) => tools.value?.paint(context),
  });
  const early = createEarlyPointers();
  fetchTools(sources, tools, { draw, said, early });
  const frame = () => [picture.view.value, picture.canvas.value, picture.ratio.value, sources.palette()];
  const session = () => [editor?.selection.value, editor?.options.value, editor?.free.value, editor?.brought.value];
  watch([frame, session, sources.footprint, tools, sources.canvas], draw, { flush: 'post' });
  watch(sources.course, () => {
    tools.value?.courseChanged();
    ghost.value = noGhost; // in the same breath as the new course is shown
    draw();
  });
  watch(
    () => editor?.tool.value,
    () => {
      hand.hand.release();
      tools.value?.toolChanged();
      early.forget();
      draw();
    },
  );
  return {
    isUsed,
    said,
    cursor,
    crosshair: () => (isUsed.value ? (tools.value?.crosshair() ?? null) : null),
    showSelected: () => void tools.value?.showSelected(),
    on: handlers(hand, () => (isUsed.value ? tools.value : null), { isUsed, early }),
  };
}

function fetchTools(
  sources: ToolSurfaceSources,
  tools: ShallowRef<ArenaTools | null>,
  to: { draw: () => void; said: ShallowRef<string>; early: EarlyPointers },
): void {
  const { editor, ghost } = sources;
  if (editor === null) return;
  let isGone = false;
  onBeforeUnmount(() => {
    isGone = true;
    editor.unfinished.value = null;
    editor.view.value = null;
  });
  const fetch = (): void => {
    import('./arena-tools').then(
      ({ createArenaTools }) => {
        if (isGone) return;
        tools.value ??= createArenaTools({
          ...sources,
          editor,
          inkCanvas: () => sources.ink.value,
          redraw: to.draw,
          showGhost: (now) => {
            if (!isSameGhost(now, ghost.value)) ghost.value = now;
          },
          say: (words) => (to.said.value = words),
        });
        to.early.replay(tools.value);
      },
      () => to.early.forget(), // no connection at the moment: loaded with the next tool
    );
  };
  watch(editor.tool, (tool) => tool !== 'hand' && tools.value === null && fetch(), { immediate: true });
}

/** Each event is passed to the chosen tool; the wheel, and without a tool every event, is passed to the hand tool. */
function handlers(
  { on: hand, zoomKey }: ArenaHand,
  tools: () => ArenaTools | null,
  { isUsed, early }: { isUsed: ComputedRef<boolean>; early: EarlyPointers },
): ArenaHand['on'] {
  const lead =
    (name: GestureEvent) =>
    (event: PointerEvent): void => {
      const chosen = tools();
      if (!isUsed.value) hand[name](event);
      else if (chosen !== null) chosen[name](event);
      else {
        if (name === 'pointerdown' && event.currentTarget instanceof Element)
          event.currentTarget.setPointerCapture(event.pointerId);
        early.note(name, event);
      }
    };
  return {
    pointerdown: lead('pointerdown'),
    pointermove: lead('pointermove'),
    pointerup: lead('pointerup'),
    pointercancel: lead('pointercancel'),
    lostpointercapture: (event) => (isUsed.value ? tools()?.pointercancel(event) : hand.lostpointercapture(event)),
    pointerleave: () => (isUsed.value ? tools()?.pointerleave() : hand.pointerleave()),
    wheel: (event) => hand.wheel(event),
    keydown(event) {
      if (!isUsed.value) {
        hand.keydown(event);
        return;
      }
      const isPlain = !event.ctrlKey && !event.metaKey && !event.altKey;
      if (tools()?.keyDown(event) === true || (isPlain && zoomKey(event))) event.preventDefault();
    },
    keyup(event) {
      if (isUsed.value) tools()?.keyUp(event);
      else hand.keyup(event);
    },
    focus(event) {
      if (!isUsed.value) hand.focus(event);
      else if (event.target instanceof Element && event.target.matches(':focus-visible')) tools()?.focus();
    },
    blur() {
      tools()?.blur();
      hand.blur();
    },
  };
}
