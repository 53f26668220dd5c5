#!/bin/sh
# Shows that check_page.sh accepts a good tree and names what is wrong with each bad one.
set -eu

folder=$(dirname "$0")
. "$folder/bad_trees.sh"
root=$tree/src

check_tree() {
    sh "$folder/check_page.sh" "$tree/src" state data views
}

good_tree() {
    rm -rf "$tree/src"
    file state/state.ts 'export const body = 1;'
    file state/store.ts 'import { body } from "./state.ts";'
    file data/api.ts '/** What comes from "./main.ts" in words is no import. */' \
        'import {' '  body,' '} from "../state/state.ts";'
    file views/chart.ts 'import uPlot from "uplot";' 'import type { Api } from "../data/api.ts";'
    file later.ts 'export { Chart } from "./views/chart.ts";'
    file main.ts 'import "./page.css";' 'const later = () => import("./later.ts");'
}

good_tree
expect accepts 'a tree whose imports flow one way' ''

good_tree
file state/back.ts '' 'import { start } from "../data/api.ts";'
expect rejects 'an import from a later folder, with file and line' 'comes after it.*\[state/back.ts:2\]'

good_tree
file state/back.ts 'import type {' '  Api,' '} from "../data/api.ts";'
expect rejects 'an import of types, over several lines' 'comes after it.*\[state/back.ts:3\]'

good_tree
file data/back.ts 'const chart = () => import("../views/chart.ts");'
expect rejects 'an import on demand' 'comes after it.*\[data/back.ts:1\]'

good_tree
file data/back.ts "export * from '../views/chart.ts';"
expect rejects 'a re-export' 'comes after it'

good_tree
file views/back.ts 'import { help } from "../later.ts";'
expect rejects 'an import of what puts the page together' 'comes after all folders'

good_tree
file data/a.ts 'import { b } from "./b.ts";'
file data/b.ts 'import { c } from "./c.ts";'
file data/c.ts 'import { a } from "./a.ts";'
expect rejects 'files that import each other' 'data/a.ts -> data/b.ts -> data/c.ts -> data/a.ts'

good_tree
file data/near.ts 'import { body } from "../state/state";'
expect rejects 'a file without its extension' 'no file of the page'

good_tree
file extras/new.ts ''
expect rejects 'a folder that is not in the order' 'in no known folder'

rm -rf "$tree/src"
mkdir "$tree/src"
expect rejects 'an empty tree' 'no source files'

[ "$failures" -eq 0 ]
