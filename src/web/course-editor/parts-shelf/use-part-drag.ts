import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';

import type { Clip, Pasted } from '#editor/clipboard';
import { brought } from '#editor/parts/bring';
import type { ToolContext } from '#editor/tools/tool';

import type { CourseEditorModel } from '../state/course-editor-model';

/** How far a mouse moves before it drags, in px. Chosen: a hand that clicks shakes less. */
const SLIP_PX = 5;
/** How long a finger rests before it lifts a part, in ms; before that it scrolls the shelf. */
const LIFT_MS = 300;
/** How far a finger may move while it rests, in px. */
const REST_PX = 10;

/** A part that is carried: what it is, and where the pointer is in the window. */
export interface Carried {
  readonly clip: Clip;
  readonly xPx: number;
  readonly yPx: number;
  /** It is over the arena, which shows it as it would lie there. */
  readonly isOver: boolean;
}

/** What a drag from the shelf works on. */
export interface PartDragPorts {
  readonly editor: Pick<CourseEditorModel, 'view' | 'brought' | 'free' | 'choose' | 'commit'>;
  readonly course: () => Pick<ToolContext, 'scene' | 'footprint'>;
}

/** The drag of a part from the shelf onto the course. */
export interface PartDrag {
  readonly carried: Readonly<ShallowRef<Carried | null>>;
  /** A pointer goes down on a card. */
  down(event: PointerEvent, clip: Clip): void;
  /** Whether a click belongs to a drag that has just ended: then it inserts nothing. */
  swallows(): boolean;
  /** For `touchmove` on the shelf: a finger that carries a part scrolls nothing. */
  keepStill(event: TouchEvent): void;
}

/** Leads a part by mouse, pen or finger. Listens to the window while a pointer is down. */
export function usePartDrag({ editor, course }: PartDragPorts): PartDrag {
  const carried = shallowRef<Carried | null>(null);
  let press: { readonly id: number; readonly x: number; readonly y: number; readonly clip: Clip } | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let hasDragged = false;
  let made: Pasted | null = null;

  function lift(x: number, y: number): void {
    hasDragged = true;
    editor.choose('select'); // its tools show what is brought
    carry(x, y);
  }

  function carry(xPx: number, yPx: number): void {
    if (press === null) return;
    const at = editor.view.value?.at(xPx, yPx) ?? null;
    const how = { free: editor.free.value, reachMm: editor.view.value?.reachMm() ?? 0 };
    made = at && brought(course(), press.clip, at, how);
    editor.brought.value = made?.edit ?? null;
    carried.value = { clip: press.clip, xPx, yPx, isOver: made !== null };
  }

  function move(event: PointerEvent): void {
    if (press === null || event.pointerId !== press.id) return;
    if (carried.value !== null) return carry(event.clientX, event.clientY);
    const farPx = Math.max(Math.abs(event.clientX - press.x), Math.abs(event.clientY - press.y));
    if (event.pointerType !== 'touch' && farPx > SLIP_PX) lift(event.clientX, event.clientY);
    else if (event.pointerType === 'touch' && farPx > REST_PX) drop(); // it scrolls
  }

  /** Lets go; what is over the arena lies there. */
  function up(event: PointerEvent): void {
    if (press === null || event.pointerId !== press.id) return;
    const lies = carried.value === null ? null : made;
    drop();
    if (lies !== null) editor.commit(lies.edit, lies.selection);
  }

  /** Ends without an edit. */
  function drop(): void {
    clearTimeout(timer);
    press = made = carried.value = editor.brought.value = null;
    for (const [name, listener] of listeners) removeEventListener(name, listener, true);
  }

  function key(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || carried.value === null) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    drop();
  }

  const listeners = Object.entries({
    pointermove: move,
    pointerup: up,
    pointercancel: drop,
    keydown: key,
  }) as [string, EventListener][];

  onScopeDispose(drop);
  return {
    carried,
    down(event, clip) {
      hasDragged = false;
      if (event.button !== 0 || press !== null) return;
      // Objects of its own each time: no two parts are copies of each other.
      press = { id: event.pointerId, x: event.clientX, y: event.clientY, clip: ownCopy(clip) };
      for (const [name, listener] of listeners) addEventListener(name, listener, true);
      if (event.pointerType === 'touch') timer = setTimeout(() => lift(event.clientX, event.clientY), LIFT_MS);
    },
    swallows: () => hasDragged,
    keepStill(event) {
      if (carried.value !== null) event.preventDefault();
    },
  };
}

/** The same objects anew: the editor takes copies of one object for copies of each other. */
export const ownCopy = ({ objects }: Clip): Clip => ({ objects: objects.map((object) => ({ ...object })) });
