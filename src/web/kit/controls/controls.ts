import type { Plugin } from 'vue';

import PageMenu from '../overlays/PageMenu.vue';
import PageListHeading from './PageListHeading.vue';
import PageListItem from './PageListItem.vue';
import PageButton from './PageButton.vue';
import PageIcon from './PageIcon.vue';
import PageList from './PageList.vue';

/** Lets the templates of all rooms use the controls of the page without importing them. Dialogs are fetched late: what shows one imports it. */
export const controls: Plugin = {
  install(app) {
    app.component('PageButton', PageButton);
    app.component('PageIcon', PageIcon);
    app.component('PageList', PageList);
    app.component('PageListItem', PageListItem);
    app.component('PageListHeading', PageListHeading);
    app.component('PageMenu', PageMenu);
  },
};

declare module 'vue' {
  interface GlobalComponents {
    PageButton: typeof PageButton;
    PageIcon: typeof PageIcon;
    PageList: typeof PageList;
    PageListItem: typeof PageListItem;
    PageListHeading: typeof PageListHeading;
    PageMenu: typeof PageMenu;
  }
}
