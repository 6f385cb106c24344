import {
  mdiDeleteSweepOutline,
  mdiFormatListBulleted,
  mdiImageOutline,
  mdiMapMarkerPath,
  mdiPrinterOutline,
  mdiRedo,
  mdiTextBoxEditOutline,
  mdiToyBrickOutline,
  mdiUndo,
} from '@mdi/js';
import { h } from 'vue';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import toolWords from '../../kit/words/tools';
import { allTools, toolLetters, type PaletteTool } from './palette/tool-list';
import ToolIcon from './parts/ToolIcon.vue';
import editingWords from './words/editing';
import words from './words/help';

const entry = (
  id: keyof typeof words,
  icon: HelpEntry['icon'],
  name: HelpEntry['name'],
  ...covers: string[]
): HelpEntry => ({
  id,
  section: 'tools',
  icon,
  name,
  text: () => t(words[id]),
  covers,
});
const tool = (id: PaletteTool): HelpEntry =>
  entry(
    `tool-${id}`,
    () => h(ToolIcon, { tool: id }),
    () => t(toolWords[id].name),
    id,
  );
const { panels } = editingWords;

export const helpEntries: readonly HelpEntry[] = [
  ...allTools.map(tool),
  entry('undo', mdiUndo, () => t('editing.undo'), 'undo'),
  entry('redo', mdiRedo, () => t('editing.redo'), 'redo'),
  entry('course-more', mdiMapMarkerPath, () => t('editing.more'), 'course-more'),
  entry('parts', mdiToyBrickOutline, () => t(panels.parts), 'bench-parts'),
  entry('course-list', mdiFormatListBulleted, () => t(panels.list), 'editor-*', 'line-*', 'menu-print'),
  entry('course-settings', mdiTextBoxEditOutline, () => t(panels.course)),
  entry('background', mdiImageOutline, () => t(panels.background)),
  entry('print', mdiPrinterOutline, () => t(panels.print)),
  entry('clear-course', mdiDeleteSweepOutline, () => t(panels.clear), 'editor-clear'),
  {
    ...entry('key-tools', '', () => Object.values(toolLetters).join(' ').toUpperCase()),
    section: 'keys',
    after: 'key-board',
    keys: Object.values(toolLetters).map((letter) => letter.toUpperCase()),
  },
];
