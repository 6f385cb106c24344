import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { linkOf, type Omitted } from '#project/link/link';

import { useWork } from '../work/model/parts';
import { readyCourses } from './open-address';
import { presentProject } from './save-work';

/** The link to the present project. */
export interface ShareLink {
  /** Whether the program comes along. */
  readonly program: ShallowRef<boolean>;
  /** The whole address; `null`: the project is too large for one. */
  readonly link: ComputedRef<string | null>;
  /** The pictures that were left out because there was no room. */
  readonly omitted: ComputedRef<readonly Omitted[]>;
}

export function useShareLink(): ShareLink {
  const app = useWork();
  const program = shallowRef(true);
  const made = computed(() => linkOf(presentProject(app), { courses: readyCourses, program: program.value }));
  return {
    program,
    link: computed(() => made.value && `${location.origin}${location.pathname}#${made.value.fragment}`),
    omitted: computed(() => made.value?.omitted ?? []),
  };
}
