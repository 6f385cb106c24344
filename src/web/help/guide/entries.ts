import {
  mdiAccessPoint,
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
  mdiDeleteSweepOutline,
  mdiDotsVertical,
  mdiFileCodeOutline,
  mdiFilterVariant,
  mdiFlagCheckered,
  mdiFolderOpenOutline,
  mdiGestureTap,
  mdiHandBackRightOutline,
  mdiHelpCircleOutline,
  mdiHelpRhombusOutline,
  mdiKeyboardReturn,
  mdiLanguagePython,
  mdiHistory,
  mdiLightbulbOutline,
  mdiMapMarkerPath,
  mdiMapOutline,
  mdiPause,
  mdiPencilOutline,
  mdiPencilRuler,
  mdiPlay,
  mdiPlus,
  mdiPuzzleOutline,
  mdiRestart,
  mdiShareVariant,
  mdiSkipNext,
  mdiSpeedometer,
  mdiStop,
  mdiTableLarge,
  mdiThemeLightDark,
  mdiTranslate,
  mdiTuneVariant,
  mdiUsb,
  mdiViewDashboardOutline,
  mdiWalk,
} from '@mdi/js';

import type { HelpEntry } from '../../kit/features/feature';
import { t } from '../../kit/i18n';
import type { TextKey } from '../../kit/i18n/texts';
import modeWords from '../../session/mode/words';
import type { GuideContent, OwnName } from './content/content';
import { sectionIds, type EntryId, type KEY_IDS, type SectionId } from './content/entry-ids';

/** A control, or something else that the help explains. */
export interface GuideEntry extends Pick<HelpEntry, 'id' | 'icon' | 'covers' | 'keys'> {
  /** Its label, so that both always say the same. */
  readonly name: (content: GuideContent) => string;
  readonly text: (content: GuideContent) => string;
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
  run: ofKey(mdiPlay, 'bar.run', 'run'),
  stop: ofKey(mdiStop, 'bar.stop', 'stop'),
  pause: ofKey(mdiPause, 'bar.pause', 'pause', 'bar.resume'),
  step: ofKey(mdiSkipNext, 'bar.step', 'step'),
  reset: ofKey(mdiRestart, 'bar.reset', 'reset'),
  speed: ofKey(mdiSpeedometer, 'bar.speedAndSound', 'speed', 'menu-speed'),
  device: ofKey(mdiChip, 'device.choose', 'device'),
  course: ofKey(mdiMapMarkerPath, 'bar.course', 'course', 'menu-course'),
  share: of(mdiShareVariant, () => t('bar.share'), 'share', 'menu-*'),
  save: of(mdiContentSaveOutline, () => t('bar.save'), 'menu-save'),
  open: of(mdiFolderOpenOutline, () => t('menu.open'), 'menu-open'),
  language: ofKey(mdiTranslate, 'bar.language'),
  theme: ofKey(mdiThemeLightDark, 'bar.theme'),
  help: ofOwn(mdiHelpCircleOutline, 'help', 'menu-help', 'menu-keys'),
  menu: ofKey(mdiDotsVertical, 'bar.menu', 'menu'),
  stages: ofOwn(mdiPencilRuler, 'stages', 'logo'),
  tour: ofOwn(mdiWalk, 'tour', 'menu-tour'),
  'real-device': ofOwn(mdiUsb, 'real-device', 'menu-real-device'),
  'save-program': of(mdiFileCodeOutline, () => t('menu.saveProgram')),
  'save-scene': of(mdiMapOutline, () => t('menu.saveScene')),
  panes: ofKey(mdiViewDashboardOutline, 'menu.panes', 'pane-board', 'pane-arena', 'bar.showBoard', 'bar.hideBoard', 'bar.showArena', 'bar.hideArena'), // prettier-ignore
  'device-check': ofKey(mdiCheckboxMarkedOutline, 'deviceCheck.setting', 'device-check-switch'),
  files: ofOwn(mdiLanguagePython, 'files', 'file-tab'),
  'new-file': of(mdiPlus, () => t('code.newFile')),
  'file-menu': of(mdiDotsVertical, () => t('code.fileMenu', { file: 'main.py' }), 'code.fileMenu'),
  commands: ofOwn(mdiPuzzleOutline, 'commands', 'commands-toggle'),
  suggestions: ofOwn(mdiLightbulbOutline, 'suggestions'),
  explain: ofOwn(mdiHelpCircleOutline, 'explain'),
  'break-points': ofOwn(mdiCircle, 'break-points'),
  buttons: ofOwn(mdiGestureTap, 'buttons', 'board'),
  sensors: ofKey(mdiTuneVariant, 'sensors.pane', 'panel-*'),
  radio: ofKey(mdiAccessPoint, 'radio.pane'),
  log: ofKey(mdiTableLarge, 'dataLog.pane'),
  'arena-hand': ofOwn(mdiHandBackRightOutline, 'arena-hand', 'arena'),
  'look-back': of(
    mdiHistory,
    () => t(modeWords.lookBack),
    'save-run',
    'save-run-*',
    'save-run-file',
    'save-run-link',
    'save-run-pictures',
    'go-on',
    'feedback-time',
    'time-play',
    'time-rail',
  ),
  'ask-why': ofOwn(mdiHelpRhombusOutline, 'ask-why', 'why-open', 'why-*', 'words.why'),
  readings: ofOwn(mdiCompassOutline, 'readings'),
  verdict: ofOwn(mdiFlagCheckered, 'verdict'),
  output: ofKey(mdiConsoleLine, 'console.log', 'console'),
  chart: ofKey(mdiChartLine, 'console.chart', 'tab-console', 'tab-chart', 'chart', 'chart-*'),
  together: ofKey(mdiFilterVariant, 'console.together', 'console-together'),
  copy: ofKey(mdiContentCopy, 'console.copy'),
  clear: ofKey(mdiDeleteSweepOutline, 'console.clear'),
  fold: ofKey(mdiChevronDown, 'console.fold', 'console-fold'),
  input: ofOwn(mdiKeyboardReturn, 'input', 'console-input', 'console.send'),
  interrupt: ofKey(mdiArrowTopRightBottomLeft, 'console.interrupt', 'interrupt'),
  restart: ofKey(mdiRestart, 'console.restart', 'restart'),
};

/** The keys of each shortcut, as they are shown. */
const keysOf: Readonly<Record<KeyId, readonly string[]>> = {
  'key-run': ['Ctrl', 'Enter'],
  'key-stop': ['Ctrl', 'Shift', 'Enter'],
  'key-save': ['Ctrl', 'S'],
  'key-open': ['Ctrl', 'O'],
  'key-help': ['F1'],
  'key-explain': ['F1'],
  'key-leave': ['Esc', 'Tab'],
  'key-comment': ['Ctrl', '/'],
  'key-board': ['A', 'B', 'L'],
  'key-arrows': ['←', '→', '↑', '↓'],
  'key-draw': ['Enter'],
  'key-turn': ['Q', 'E', 'R'],
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

function ownEntry(id: EntryId): GuideEntry {
  const text = ({ texts }: GuideContent): string => texts[id];
  if (!isKey(id)) return { id, text, ...parts[id] };
  const keys = keysOf[id];
  return { id, text, keys, icon: '', name: () => keys.join(' '), covers: [] };
}

/** A section of the help with its entries, in the order in which they are shown. */
export interface GuideSection {
  readonly id: SectionId;
  readonly entries: readonly GuideEntry[];
}

/** The sections of the help: its own entries, and those of features at their places. */
export const guideSections = (contributed: readonly HelpEntry[]): readonly GuideSection[] =>
  (Object.keys(sectionIds) as SectionId[]) // its keys are written down in one place
    .map((id) => ({
      id,
      entries: inserted(
        sectionIds[id].map(ownEntry),
        contributed.filter(({ section }) => section === id),
      ),
    }));

/**
 * The entries with those of features, each after the one that it follows, which may be inserted itself; without such a
 * one at the end.
 */
function inserted(own: readonly GuideEntry[], more: readonly HelpEntry[]): readonly GuideEntry[] {
  const entries = [...own];
  let waiting = more;
  while (waiting.length > 0) {
    const ready = waiting.filter(({ after }) => !waiting.some(({ id }) => id === after));
    for (const entry of ready) {
      const place = entries.findIndex(({ id }) => id === entry.after);
      entries.splice(place < 0 ? entries.length : place + 1, 0, entry);
    }
    waiting = ready.length === 0 ? [] : waiting.filter((entry) => !ready.includes(entry));
  }
  return entries;
}
