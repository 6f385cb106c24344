import type { Component } from 'vue';

import type { BarItem } from '../../../session/layout/bar-item';
import CourseMenu from './CourseMenu.vue';

export const barItems: readonly BarItem[] = [
  { place: 'work', order: 10, kinds: ['wide', 'medium', 'narrow'], view: CourseMenu as Component },
];
