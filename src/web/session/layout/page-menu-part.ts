import type { MenuPart } from '../../kit/features/feature';
import { useVisit } from '../visit/parts';

/** The main menu's entry for a page of its own; left out where a host chooses what is shown. Called in the menu's set-up. */
export function pageMenuPart(page: {
  readonly id: string;
  readonly order: number;
  readonly icon: string;
  readonly title: () => string;
  readonly open: () => void;
}): MenuPart {
  const { host } = useVisit();
  const { id, icon, order } = page;
  return {
    group: 'pages',
    order,
    entries: () =>
      host.parts.value !== null
        ? []
        : [{ id, testId: `menu-${id}`, icon, title: page.title(), act: (menu) => menu.leaveFor(page.open) }],
  };
}
