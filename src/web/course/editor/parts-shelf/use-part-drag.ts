import { onScopeDispose, shallowRef } from 'vue';

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

/** The models that a drag from the shelf works on. */
export interface PartDragPorts {
  readonly editor: Pick<CourseEditorModel, 'view' | 'brought' | 'free' | 'choose' | 'commit'>;
  readonly course: () => Pick<ToolContext, 'scene' | 'footprint'>;
}

/** The drag of parts by mouse, pen or finger. It ends with the shelf. */
export function usePartDrag(ports: PartDragPorts): PartDrag {
  const drag = new PartDrag(ports);
  onScopeDispose(drag.drop);
  return drag;
}

/** The drag of a part from the shelf onto the course. Listens to the window while a pointer is down. */
export class PartDrag {
  readonly carried = shallowRef<Carried | null>(null);
  private press: { readonly id: number; readonly x: number; readonly y: number; readonly clip: Clip } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private hasDragged = false;
  private made: Pasted | null = null;
  private readonly listeners: readonly (readonly [string, EventListener])[];

  constructor(private readonly ports: PartDragPorts) {
    const { move, up, drop, key } = this;
    const listeners = { pointermove: move, pointerup: up, pointercancel: drop, keydown: key };
    this.listeners = Object.entries(listeners) as [string, EventListener][];
  }

  /** A pointer goes down on a card. */
  down(event: PointerEvent, clip: Clip): void {
    this.hasDragged = false;
    if (event.button !== 0 || this.press !== null) return;
    const { pointerId: id, clientX: x, clientY: y } = event;
    this.press = { id, x, y, clip: ownCopy(clip) };
    for (const [name, listener] of this.listeners) addEventListener(name, listener, true);
    if (event.pointerType === 'touch') this.timer = setTimeout(() => this.lift(x, y), LIFT_MS);
  }

  /** True if a click belongs to a drag that has just ended: then it inserts nothing. */
  swallows(): boolean {
    return this.hasDragged;
  }

  /** For `touchmove` on the shelf: a finger that carries a part scrolls nothing. */
  readonly keepStill = (event: TouchEvent): void => {
    if (this.carried.value !== null) event.preventDefault();
  };

  /** Ends without an edit. */
  readonly drop = (): void => {
    clearTimeout(this.timer);
    this.press = this.made = this.carried.value = this.ports.editor.brought.value = null;
    for (const [name, listener] of this.listeners) removeEventListener(name, listener, true);
  };

  private readonly move = (event: PointerEvent): void => {
    const { press } = this;
    if (press === null || event.pointerId !== press.id) return;
    if (this.carried.value !== null) return this.carry(event.clientX, event.clientY);
    const farPx = Math.max(Math.abs(event.clientX - press.x), Math.abs(event.clientY - press.y));
    if (event.pointerType !== 'touch' && farPx > SLIP_PX) this.lift(event.clientX, event.clientY);
    else if (event.pointerType === 'touch' && farPx > REST_PX) this.drop(); // it scrolls
  };

  /** Lets go: a part that is over the arena is put there. */
  private readonly up = (event: PointerEvent): void => {
    if (event.pointerId !== this.press?.id) return;
    const lies = this.carried.value === null ? null : this.made;
    this.drop();
    if (lies !== null) this.ports.editor.commit(lies.edit, lies.selection);
  };

  private readonly key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || this.carried.value === null) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.drop();
  };

  private lift(xPx: number, yPx: number): void {
    this.hasDragged = true;
    this.ports.editor.choose('select'); // its tools show what is brought
    this.carry(xPx, yPx);
  }

  private carry(xPx: number, yPx: number): void {
    if (this.press === null) return;
    const { editor, course } = this.ports;
    const { clip } = this.press;
    const at = editor.view.value?.at(xPx, yPx) ?? null;
    const how = { free: editor.free.value, reachMm: editor.view.value?.reachMm() ?? 0 };
    this.made = at && brought(course(), clip, at, how);
    editor.brought.value = this.made?.edit ?? null;
    this.carried.value = { clip, xPx, yPx, isOver: this.made !== null };
  }
}

/** The same objects anew: the editor takes copies of one object for copies of each other. */
export const ownCopy = ({ objects }: Clip): Clip => ({ objects: objects.map((object) => ({ ...object })) });
