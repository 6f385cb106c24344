import { computed, shallowRef, type ComputedRef } from 'vue';

import type { RewrittenLine } from '#intake/document';
import type { SourceFile } from '#project/project';
import type { Note } from '#project/webtigerpython/note';
import type { Scene } from '#scene/scene';

import type { WorkModel } from '../../session/work/model/work-model';
import { asksForFields } from './lidar-order';

/** The content of a link or a course file of WebTigerPython that was opened. */
export interface Brought {
  /** As they were opened; none: it brought a world alone. */
  readonly files: readonly SourceFile[];
  /** Its world as a course; `null`: none, or none that can be read. */
  readonly scene: Scene | null;
  readonly isLink: boolean;
  readonly notes: readonly Note[];
  readonly rewritten: readonly RewrittenLine[];
}

/** The work from WebTigerPython about which a card tells. */
export interface BroughtModel {
  /** `null`: it was closed, or other work is open. */
  readonly shown: ComputedRef<Brought | null>;
  /** Tells of work that has just been opened; a program alone that came as it was needs no words. */
  tell(brought: Brought): void;
  close(): void;
}

/** Makes the model. */
export function createBroughtModel({ works }: Pick<WorkModel, 'works'>): BroughtModel {
  const told = shallowRef<{ readonly brought: Brought; readonly work: number } | null>(null);
  return {
    shown: computed(() => (told.value?.work === works.value ? told.value.brought : null)),
    tell: (brought) => (told.value = hasToTell(brought) ? { brought, work: works.value } : null),
    close: () => (told.value = null),
  };
}

const hasToTell = ({ files, scene, notes }: Brought): boolean =>
  scene !== null || notes.length > 0 || asksForFields(files);
