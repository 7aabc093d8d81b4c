// What index.html says when the page's script does not load. Its table of words does not load then either, so these
// words are in index.html itself, in all languages: see web/unloaded.ts.

import type { Language } from "./language";

/** Text between backquotes is shown as code; `{0}` stands for a reason or an address. */
export interface UnloadedWords {
  /** It was opened as a file. */
  file: string;
  /** It is in a frame that may load nothing. */
  sandbox: string;
  /** It could not load, for a reason. */
  failed: string;
  /** Reasons. */
  missing: string;
  old: string;
  slow: string;
}

export const UNLOADED: Record<Language, UnloadedWords> = {
  en: {
    file: "This page was opened as a file, so the browser does not let it load its parts. Run `rimroll lab`, or serve the page’s folder with a web server: run `python -m http.server` in that folder and open `http://localhost:8000`.",
    sandbox:
      "This page is in a sandboxed frame and cannot load its parts. Open `{0}` in its own tab, or add `allow-same-origin` to the frame’s sandbox attribute.",
    failed:
      "This page could not load: {0}. Reload it, in a browser from 2023 or later. Without a network, run `rimroll lab`, which serves it from your own machine.",
    missing: "its script is missing",
    old: "this browser is too old",
    slow: "This page is taking long to load. Wait, reload it, or run `rimroll lab` on your own machine.",
  },
  de: {
    file: "Diese Seite wurde als Datei geöffnet, deshalb lässt der Browser sie ihre Teile nicht laden. Starte `rimroll lab`, oder stelle den Ordner der Seite über einen Webserver bereit: Starte in diesem Ordner `python -m http.server` und öffne `http://localhost:8000`.",
    sandbox:
      "Diese Seite steht in einem abgeschotteten Rahmen und kann ihre Teile nicht laden. Öffne `{0}` in einem eigenen Tab, oder ergänze `allow-same-origin` im Attribut sandbox des Rahmens.",
    failed:
      "Diese Seite konnte nicht geladen werden: {0}. Lade sie neu, in einem Browser von 2023 oder später. Ohne Netz starte `rimroll lab`, das die Seite auf deinem eigenen Rechner bereitstellt.",
    missing: "ihr Skript fehlt",
    old: "dieser Browser ist zu alt",
    slow: "Diese Seite lädt ungewöhnlich lange. Warte, lade sie neu, oder starte `rimroll lab` auf deinem eigenen Rechner.",
  },
  es: {
    file: "Esta página se ha abierto como archivo, por lo que el navegador no le permite cargar sus partes. Ejecuta `rimroll lab`, o sirve la carpeta de la página con un servidor web: ejecuta `python -m http.server` en esa carpeta y abre `http://localhost:8000`.",
    sandbox:
      "Esta página está en un marco aislado y no puede cargar sus partes. Abre `{0}` en una pestaña propia, o añade `allow-same-origin` al atributo sandbox del marco.",
    failed:
      "No se ha podido cargar esta página: {0}. Vuelve a cargarla, en un navegador de 2023 o posterior. Sin conexión, ejecuta `rimroll lab`, que la sirve desde tu propio equipo.",
    missing: "falta su script",
    old: "este navegador es demasiado antiguo",
    slow: "Esta página tarda mucho en cargarse. Espera, vuelve a cargarla o ejecuta `rimroll lab` en tu propio equipo.",
  },
  fr: {
    file: "Cette page a été ouverte comme un fichier ; le navigateur ne lui permet donc pas de charger ses parties. Lancez `rimroll lab`, ou servez le dossier de la page avec un serveur web : lancez `python -m http.server` dans ce dossier et ouvrez `http://localhost:8000`.",
    sandbox:
      "Cette page se trouve dans un cadre isolé et ne peut pas charger ses parties. Ouvrez `{0}` dans un onglet, ou ajoutez `allow-same-origin` à l’attribut sandbox du cadre.",
    failed:
      "Cette page n’a pas pu être chargée : {0}. Rechargez-la, dans un navigateur de 2023 ou plus récent. Sans réseau, lancez `rimroll lab`, qui la sert depuis votre propre machine.",
    missing: "son script est introuvable",
    old: "ce navigateur est trop ancien",
    slow: "Cette page met longtemps à se charger. Attendez, rechargez-la, ou lancez `rimroll lab` sur votre propre machine.",
  },
  pt: {
    file: "Esta página foi aberta como arquivo, por isso o navegador não permite que ela carregue as suas partes. Execute `rimroll lab`, ou sirva a pasta da página com um servidor web: execute `python -m http.server` nessa pasta e abra `http://localhost:8000`.",
    sandbox:
      "Esta página está em um quadro isolado e não consegue carregar as suas partes. Abra `{0}` em uma aba própria, ou acrescente `allow-same-origin` ao atributo sandbox do quadro.",
    failed:
      "Não foi possível carregar esta página: {0}. Recarregue-a, em um navegador de 2023 ou mais recente. Sem rede, execute `rimroll lab`, que a serve a partir do seu próprio computador.",
    missing: "falta o seu script",
    old: "este navegador é antigo demais",
    slow: "Esta página está demorando para carregar. Espere, recarregue-a ou execute `rimroll lab` no seu próprio computador.",
  },
  zh: {
    file: "本页是作为文件打开的，浏览器因此不允许它加载各个部分。请运行 `rimroll lab`，或用网页服务器提供本页所在的文件夹：在该文件夹中运行 `python -m http.server`，然后打开 `http://localhost:8000`。",
    sandbox:
      "本页位于沙盒框架中，无法加载各个部分。请在单独的标签页中打开 `{0}`，或在框架的 sandbox 属性中加上 `allow-same-origin`。",
    failed:
      "本页无法加载：{0}。请用 2023 年或更新的浏览器重新加载。没有网络时，请运行 `rimroll lab`，由你自己的电脑提供本页。",
    missing: "缺少脚本",
    old: "浏览器版本过旧",
    slow: "本页加载时间过长。请稍候、重新加载，或在你自己的电脑上运行 `rimroll lab`。",
  },
};
