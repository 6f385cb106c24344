import type { Plugin } from 'vue';

import PageDialog from '../overlays/PageDialog.vue';
import PageMenu from '../overlays/PageMenu.vue';
import ListHeading from './ListHeading.vue';
import ListItem from './ListItem.vue';
import PageButton from './PageButton.vue';
import PageIcon from './PageIcon.vue';
import PageList from './PageList.vue';

/** Lets the templates of all rooms use the controls of the page without importing them. */
export const controls: Plugin = {
  install(app) {
    app.component('VBtn', PageButton);
    app.component('VDialog', PageDialog);
    app.component('VIcon', PageIcon);
    app.component('VList', PageList);
    app.component('VListItem', ListItem);
    app.component('VListSubheader', ListHeading);
    app.component('VMenu', PageMenu);
  },
};

declare module 'vue' {
  interface GlobalComponents {
    VBtn: typeof PageButton;
    VDialog: typeof PageDialog;
    VIcon: typeof PageIcon;
    VList: typeof PageList;
    VListItem: typeof ListItem;
    VListSubheader: typeof ListHeading;
    VMenu: typeof PageMenu;
  }
}
