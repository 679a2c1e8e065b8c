package particles.output.report;

/** The style sheet and script of a report, for screens, phones and paper. */
final class ReportStyle {
    /**
     * The style sheet. On paper two charts fit on a sheet, or one of many parts; none is divided, and tables repeat
     * their heads.
     */
    static final String CSS = """
            :root { color-scheme: light; }
            body { margin: 0 auto; padding: 1rem; max-width: 76rem; color: #1b1b1f; background: #fff;
              font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
            h1 { font-size: 1.7rem; line-height: 1.25; margin: 0.5rem 0; }
            h2 { font-size: 1.25rem; line-height: 1.3; margin: 0 0 0.5rem; }
            h3 { font-size: 1rem; margin: 1.5rem 0 0.3rem; }
            section { border-top: 2px solid #c9ccd3; margin-top: 2.5rem; padding-top: 1rem; }
            .task { color: #555a64; font-size: 0.875rem; margin: 0 0 0.3rem; }
            .command { white-space: nowrap; }
            .failure { white-space: pre-line; border-left: 4px solid #a00; padding: 0.3rem 0.8rem;
                  background: #fff3f2; }
            nav { background: #f3f4f7; padding: 0.8rem 1rem; }
            nav h2 { font-size: 1rem; margin: 0; }
            nav ol { margin: 0.3rem 0 0; padding-left: 1.4rem; }
            nav li { margin: 0.25rem 0; }
            a { color: #0a4b9c; }
            figure { margin: 1.2rem 0; }
            figure .scroll { overflow-x: auto; }
            figure button { display: block; margin: 0; padding: 0; border: 0; background: none; cursor: zoom-in;
              width: 100%; }
            figure button.large { cursor: zoom-out; width: auto; }
            img { display: block; max-width: 100%; max-height: 95vh; height: auto; margin: 0 auto; }
            button.large img { max-width: none; max-height: none; }
            figcaption { color: #3a3e47; font-size: 0.9rem; margin-top: 0.4rem; }
            .table { overflow-x: auto; max-width: 100%; }
            table { border-collapse: collapse; font-size: 0.8rem; }
            th, td { padding: 0.2rem 0.45rem; border-bottom: 1px solid #d9dbe0; text-align: left; vertical-align: top; }
            td.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
            td.text { min-width: 6rem; }
            td:first-child { min-width: 0; white-space: nowrap; position: sticky; left: 0; background: #fff; }
            th { vertical-align: bottom; border-bottom: 2px solid #8a8f99; }
            .ends th { font-weight: normal; white-space: nowrap; }
            .ends td:first-child { position: static; }
            th button { all: unset; cursor: pointer; font-weight: bold; }
            th button:focus-visible { outline: 2px solid #0a4b9c; }
            th.number { text-align: right; }
            th button::after { content: " \\2195"; color: #8a8f99; }
            th[aria-sort=ascending] button::after { content: " \\2191"; color: inherit; }
            th[aria-sort=descending] button::after { content: " \\2193"; color: inherit; }
            summary { cursor: pointer; }
            .printed { display: none; }
            footer { margin-top: 2rem; color: #555a64; font-size: 0.875rem; }
            @media print {
              @page { margin: 12mm; }
              body { font-size: 10pt; max-width: none; padding: 0; }
              a { color: inherit; text-decoration: none; }
              section { margin-top: 6mm; padding-top: 3mm; }
              nav { font-size: 8.5pt; }
              p { orphans: 3; widows: 3; }
              h1, h2, h3, .task { break-after: avoid; }
              footer { break-before: avoid; }
              h2, figure, .table, tr { break-inside: avoid; }
              figure { margin: 2mm 0; }
              figcaption { margin-top: 0.5mm; font-size: 8.5pt; line-height: 1.3; }
              figure.animation, .folded { display: none; }
              .printed { display: block; }
              img, button.large img { max-width: 100%; max-height: 108mm; }
              .whole img, .whole button.large img { max-height: 185mm; }
              .table, figure .scroll { overflow: visible; }
              table { font-size: 7.5pt; width: 100%; }
              thead { display: table-header-group; }
              th, td { padding: 0.5mm 1.2mm; }
              td.text { min-width: 0; }
              td:first-child { position: static; }
              th button::after, th[aria-sort] button::after { content: ""; }
            }
            @media (max-width: 40rem) {
              body { padding: 0.7rem; }
              h1 { font-size: 1.35rem; }
              h2 { font-size: 1.1rem; }
            }
            """;

    /** The script, without the two characters that XML requires to be escaped and HTML does not allow escaped. */
    static final String SCRIPT = """
            (function () {
              "use strict";
              function key(row, column, numbers) {
                var cell = row.cells[column];
                return numbers ? parseFloat(cell.getAttribute("data-value")) : cell.textContent;
              }
              function compare(a, b, numbers, sign) {
                if (!numbers) { return sign * a.localeCompare(b); }
                if (isNaN(a) || isNaN(b)) { return (isNaN(a) ? 1 : 0) - (isNaN(b) ? 1 : 0); }
                if (a === b) { return 0; }
                return a > b ? sign : -sign;
              }
              function sort(button) {
                var head = button.closest("th");
                var body = head.closest("table").tBodies[0];
                var numbers = head.classList.contains("number");
                var direction = head.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
                Array.from(head.parentNode.cells).forEach(function (other) { other.removeAttribute("aria-sort"); });
                head.setAttribute("aria-sort", direction);
                var sign = direction === "ascending" ? 1 : -1;
                Array.from(body.rows).sort(function (a, b) {
                  return compare(key(a, head.cellIndex, numbers), key(b, head.cellIndex, numbers), numbers, sign);
                }).forEach(function (row) { body.appendChild(row); });
              }
              document.querySelectorAll("th button").forEach(function (button) {
                button.addEventListener("click", function () { sort(button); });
              });
              document.querySelectorAll("figure button").forEach(function (button) {
                button.addEventListener("click", function () { button.classList.toggle("large"); });
              });
            })();
            """;

    private ReportStyle() {
    }
}
