import {
  mdiAccessPoint,
  mdiAccountVoice,
  mdiArrowTopRightBottomLeft,
  mdiBugOutline,
  mdiCheckboxMarkedOutline,
  mdiChartLine,
  mdiChevronDown,
  mdiChip,
  mdiCircle,
  mdiCompassOutline,
  mdiConsoleLine,
  mdiContentCopy,
  mdiContentSaveOutline,
  mdiDebugStepOver,
  mdiDeleteSweepOutline,
  mdiDotsVertical,
  mdiFileCodeOutline,
  mdiFilterVariant,
  mdiFitToScreenOutline,
  mdiFlagCheckered,
  mdiFolderOpenOutline,
  mdiFormatListNumbered,
  mdiFormatListBulleted,
  mdiFullscreen,
  mdiGestureTap,
  mdiGhostOutline,
  mdiHandBackRightOutline,
  mdiHelpCircleOutline,
  mdiHelpRhombusOutline,
  mdiImageOutline,
  mdiImageFilterCenterFocus,
  mdiKeyboardReturn,
  mdiLanguagePython,
  mdiHistory,
  mdiLayersOutline,
  mdiLightbulbOutline,
  mdiLinkVariant,
  mdiMagnify,
  mdiMagnifyPlusOutline,
  mdiMapMarkerPath,
  mdiMapOutline,
  mdiMovieOpenOutline,
  mdiPause,
  mdiPencilOutline,
  mdiPencilRuler,
  mdiPlay,
  mdiPlus,
  mdiPrinterOutline,
  mdiProjectorScreenOutline,
  mdiPuzzleOutline,
  mdiToyBrickOutline,
  mdiRedo,
  mdiRestart,
  mdiClipboardCheckOutline,
  mdiClipboardEditOutline,
  mdiRobotHappyOutline,
  mdiRobotOutline,
  mdiShareVariant,
  mdiSkipNext,
  mdiSpeedometer,
  mdiStop,
  mdiTableLarge,
  mdiTextBoxEditOutline,
  mdiThemeLightDark,
  mdiTranslate,
  mdiTuneVariant,
  mdiUndo,
  mdiUsb,
  mdiVariable,
  mdiVolumeHigh,
  mdiWalk,
} from '@mdi/js';

import type { ArenaTool } from '../../course/editor/state/course-editor-model';
import { t } from '../../kit/i18n';
import type { TextKey } from '../../kit/i18n/texts';
import { toolLetters } from '../../course/editor/palette/tool-list';
import editingWords from '../../course/editor/words/editing';
import debugWords from '../../pupil/debug/words';
import classWords from '../../teacher/class/words';
import makerWords from '../../teacher/task-maker/words';
import seriesWords from '../../teacher/series/words';
import seriesWayWords from '../../session/task/series/words';
import deviceWords from '../../pupil/device/words';
import showWords from '../../session/layout/words';
import type { GuideContent, OwnName } from './content/content';
import { sectionIds, type EntryId, type KEY_IDS, type SectionId } from './content/entry-ids';

/** A control, or something else that the help explains. */
export interface GuideEntry {
  readonly id: EntryId;
  /** Its sign, or the tool whose picture stands for it. */
  readonly icon: string | { readonly tool: ArenaTool };
  /** What it is called: by its own label, so that both always say the same. */
  readonly name: (content: GuideContent) => string;
  /** Controls that it explains, by their `data-testid`, or the names of their labels. A test finds those without an entry. */
  readonly covers: readonly string[];
}

type Parts = Pick<GuideEntry, 'icon' | 'name' | 'covers'>;
const own =
  (name: OwnName): GuideEntry['name'] =>
  ({ names }) =>
    names[name];
const step = (name: OwnName, icon: string): Parts => ({ icon, name: own(name), covers: [] });
const ofKey = (icon: string, key: TextKey, ...covers: readonly string[]): Parts => ({
  icon,
  name: () => t(key),
  covers: [key, ...covers],
});
const of = (icon: string, name: () => string, ...covers: readonly string[]): Parts => ({ icon, name, covers });
const ofOwn = (icon: string, name: OwnName, ...covers: readonly string[]): Parts => ({ icon, name: own(name), covers });
const tool = (id: ArenaTool): Parts => ({
  icon: { tool: id },
  name: () => t(`tool.${id}.name`),
  covers: [id],
});

/** A shortcut is named by its keys alone. */
type KeyId = (typeof KEY_IDS)[number];
const parts: Readonly<Record<Exclude<EntryId, KeyId>, Parts>> = {
  'step-write': step('step-write', mdiPencilOutline),
  'step-run': step('step-run', mdiPlay),
  'step-change': step('step-change', mdiRestart),
  'step-error': step('step-error', mdiBugOutline),
  'step-board': step('step-board', mdiChip),
  'step-course': step('step-course', mdiMapMarkerPath),
  'step-build': step('step-build', mdiPencilRuler),
  'step-share': step('step-share', mdiShareVariant),
  run: ofKey(mdiPlay, 'bar.run', 'run', 'bar.runAgain', 'bar.again'),
  stop: ofKey(mdiStop, 'bar.stop', 'stop'),
  pause: ofKey(mdiPause, 'bar.pause', 'pause', 'bar.resume'),
  step: ofKey(mdiSkipNext, 'bar.step', 'step'),
  reset: ofKey(mdiRestart, 'bar.reset', 'reset'),
  speed: ofKey(mdiSpeedometer, 'bar.speed', 'speed'),
  sound: ofOwn(mdiVolumeHigh, 'sound', 'bar.mute', 'bar.unmute'),
  device: ofKey(mdiChip, 'device.choose', 'device'),
  course: ofKey(mdiMapMarkerPath, 'bar.course', 'course', 'course.title'),
  share: of(mdiShareVariant, () => t('bar.share'), 'share', 'menu-*'),
  save: of(mdiContentSaveOutline, () => t('bar.save'), 'save-project'),
  open: of(mdiFolderOpenOutline, () => t('bar.open'), 'open-file'),
  language: ofKey(mdiTranslate, 'bar.language'),
  theme: ofKey(mdiThemeLightDark, 'bar.theme'),
  help: ofOwn(mdiHelpCircleOutline, 'help', 'help', 'menu-help'),
  menu: ofKey(mdiDotsVertical, 'bar.menu', 'menu'),
  stages: ofOwn(mdiPencilRuler, 'stages', 'stage-*'),
  tour: ofOwn(mdiWalk, 'tour', 'menu-tour'),
  'real-device': ofOwn(mdiUsb, 'real-device', 'menu-real-device'),
  'save-program': of(mdiFileCodeOutline, () => t('menu.saveProgram')),
  'save-scene': of(mdiMapOutline, () => t('menu.saveScene')),
  'open-link': of(mdiLinkVariant, () => t('menu.openLink')),
  'show-board': ofKey(mdiChip, 'bar.showBoard', 'bar.hideBoard'),
  'show-arena': ofKey(mdiRobotOutline, 'bar.showArena', 'bar.hideArena', 'words.hide'),
  gallery: of(mdiRobotHappyOutline, () => t(deviceWords.gallery), 'gallery'),
  'task-maker': of(mdiClipboardEditOutline, () => t(makerWords.title), 'menu-task'),
  'make-series': of(mdiFormatListNumbered, () => t(seriesWords.title), 'menu-make-series'),
  series: of(mdiFormatListNumbered, () => t(seriesWayWords.back), 'menu-series'),
  class: of(mdiClipboardCheckOutline, () => t(classWords.title), 'menu-class'),
  projector: of(
    mdiProjectorScreenOutline,
    () => t(showWords.projector.title),
    'menu-projector',
    'show-projector',
    'projector-open',
  ),
  'device-check': ofKey(mdiCheckboxMarkedOutline, 'deviceCheck.setting', 'device-check-switch'),
  files: ofOwn(mdiLanguagePython, 'files', 'file-tab'),
  'new-file': ofKey(mdiPlus, 'code.newFile'),
  'file-menu': of(mdiDotsVertical, () => t('code.fileMenu', { file: 'main.py' }), 'code.fileMenu'),
  commands: ofOwn(mdiPuzzleOutline, 'commands', 'commands-toggle'),
  suggestions: ofOwn(mdiLightbulbOutline, 'suggestions'),
  explain: ofOwn(mdiHelpCircleOutline, 'explain'),
  'break-points': ofOwn(mdiCircle, 'break-points'),
  'line-by-line': of(mdiDebugStepOver, () => t(debugWords.bar), 'step-*', 'words.goOn', 'ran-open', 'ran-close'),
  variables: of(
    mdiVariable,
    () => t(debugWords.variables),
    'board-tabs',
    'words.variables',
    'tab-board',
    'tab-variables',
    'variable',
    'call',
  ),
  buttons: ofOwn(mdiGestureTap, 'buttons', 'board'),
  sensors: ofKey(mdiTuneVariant, 'sensors.pane', 'panel-*'),
  radio: ofKey(mdiAccessPoint, 'radio.pane'),
  log: ofKey(mdiTableLarge, 'dataLog.pane'),
  'arena-hand': ofOwn(mdiHandBackRightOutline, 'arena-hand', 'arena'),
  tools: of(mdiPencilRuler, () => t('editing.tools'), 'tools-toggle'),
  'look-back': ofKey(
    mdiHistory,
    'arena.lookBack',
    'look-back-open',
    'save-run',
    'save-run-*',
    'save-run-file',
    'save-run-link',
    'save-run-pictures',
    'go-on',
    'look-back-close',
    'time-play',
    'time-rail',
  ),
  'ask-why': ofOwn(mdiHelpRhombusOutline, 'ask-why', 'why-open', 'why-*', 'words.why'),
  show: ofKey(mdiLayersOutline, 'arena.showLong', 'show'),
  ghosts: of(mdiGhostOutline, () => t(showWords.ghost.title), 'ghost-away', 'ghost-*'),
  tell: of(mdiAccountVoice, () => t(showWords.tell.title), 'tell-switch', 'show-tell', 'show-tones'),
  readings: ofOwn(mdiCompassOutline, 'readings'),
  zoom: ofOwn(mdiMagnifyPlusOutline, 'zoom', 'arena.zoomIn', 'arena.zoomOut'),
  'zoom-to': ofKey(mdiMagnify, 'arena.zoomTo', 'zoom-to'),
  fit: ofKey(mdiFitToScreenOutline, 'arena.fit', 'fit'),
  near: ofKey(mdiImageFilterCenterFocus, 'arena.near', 'near'),
  cinema: ofKey(mdiMovieOpenOutline, 'arena.cinema', 'cinema'),
  fullscreen: ofOwn(mdiFullscreen, 'fullscreen', 'fullscreen'),
  verdict: ofOwn(mdiFlagCheckered, 'verdict'),
  'tool-hand': tool('hand'),
  'tool-select': tool('select'),
  'tool-rotate': tool('rotate'),
  'tool-pen': tool('pen'),
  'tool-eraser': tool('eraser'),
  'tool-block': tool('block'),
  'tool-wall': tool('wall'),
  'tool-maze': tool('maze'),
  'tool-zone': tool('zone'),
  'tool-label': tool('label'),
  'tool-start': tool('start'),
  'tool-ruler': tool('ruler'),
  undo: of(mdiUndo, () => t('editing.undo'), 'undo'),
  redo: of(mdiRedo, () => t('editing.redo'), 'redo'),
  'course-more': of(mdiDotsVertical, () => t('editing.more'), 'course-more'),
  parts: of(mdiToyBrickOutline, () => t(editingWords.panels.parts)),
  'course-list': of(mdiFormatListBulleted, () => t(editingWords.panels.list), 'editor-*'),
  'course-settings': of(mdiTextBoxEditOutline, () => t(editingWords.panels.course)),
  background: of(mdiImageOutline, () => t(editingWords.panels.background)),
  print: of(mdiPrinterOutline, () => t(editingWords.panels.print)),
  'clear-course': of(mdiDeleteSweepOutline, () => t(editingWords.panels.clear), 'editor-clear'),
  output: ofKey(mdiConsoleLine, 'console.log', 'console'),
  chart: ofKey(mdiChartLine, 'console.chart', 'tab-*', 'chart', 'chart-*'),
  together: ofKey(mdiFilterVariant, 'console.together', 'console-together'),
  copy: ofKey(mdiContentCopy, 'console.copy'),
  clear: ofKey(mdiDeleteSweepOutline, 'console.clear'),
  fold: ofKey(mdiChevronDown, 'console.fold', 'console-fold'),
  input: ofOwn(mdiKeyboardReturn, 'input', 'console-input', 'console.send'),
  interrupt: ofKey(mdiArrowTopRightBottomLeft, 'console.interrupt', 'interrupt'),
  restart: ofKey(mdiRestart, 'console.restart', 'restart'),
};

/** The keys of a shortcut; `/` parts keys that do several things, one each. */
export const keysOf: Readonly<Record<KeyId, readonly string[]>> = {
  'key-run': ['Ctrl', 'Enter'],
  'key-stop': ['Ctrl', 'Shift', 'Enter'],
  'key-save': ['Ctrl', 'S'],
  'key-help': ['F1'],
  'key-explain': ['F1'],
  'key-leave': ['Esc', 'Tab'],
  'key-comment': ['Ctrl', '/'],
  'key-board': ['A', 'B', 'L'],
  'key-tools': Object.values(toolLetters).map((letter) => letter.toUpperCase()),
  'key-arrows': ['←', '→', '↑', '↓'],
  'key-draw': ['Enter'],
  'key-turn': ['Q', 'E'],
  'key-delete': ['Delete'],
  'key-copy': ['Ctrl', 'C', 'X', 'V', 'D'],
  'key-group': ['Ctrl', 'G'],
  'key-menu': ['Shift', 'F10'],
  'key-all': ['Ctrl', 'A'],
  'key-explore': ['N'],
  'key-around': ['O'],
  'key-undo': ['Ctrl', 'Z', 'Y'],
  'key-interrupt': ['Ctrl', 'C'],
  'key-restart': ['Ctrl', 'D'],
  'key-history': ['↑', '↓'],
  'key-escape': ['Esc'],
};

const isKey = (id: EntryId): id is KeyId => id in keysOf;

/** The sections of the help with their entries, in the order in which they are shown. */
export const guideSections: readonly { readonly id: SectionId; readonly entries: readonly GuideEntry[] }[] = (
  Object.keys(sectionIds) as SectionId[]
) // its keys are written down in one place
  .map((id) => ({
    id,
    entries: sectionIds[id].map((entry) => ({
      id: entry,
      ...(isKey(entry) ? { icon: '', name: () => keysOf[entry].join(' '), covers: [] } : parts[entry]),
    })),
  }));

/** The section of an entry. */
export const sectionOf = (id: EntryId): SectionId | undefined =>
  guideSections.find(({ entries }) => entries.some((entry) => entry.id === id))?.id;
