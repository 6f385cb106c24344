import { readyScene } from '../../session/work/catalogue/ready-courses';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { linkOf, type Omitted } from '#project/link/link';
import type { Project } from '#project/project';

/** Longer links, in characters, are cut off by some chats and mail programs. */
export const LONG_LINK = 8_000;

/** The link to the present project. */
export interface ShareLink {
  /** True if the program comes along. */
  readonly program: ShallowRef<boolean>;
  /** The whole address; `null`: the project is too large for one. */
  readonly link: ComputedRef<string | null>;
  /** The pictures that were left out because there was no room. */
  readonly omitted: ComputedRef<readonly Omitted[]>;
}

/** Makes the link to a project, anew whenever that changes. */
export function useShareLink(project: () => Project): ShareLink {
  const program = shallowRef(true);
  const made = computed(() => linkOf(project(), { courses: readyScene, program: program.value }));
  return {
    program,
    link: computed(() => made.value && `${location.origin}${location.pathname}#${made.value.fragment}`),
    omitted: computed(() => made.value?.omitted ?? []),
  };
}
