PAGE_FILE = "walk.html"


def write_page(): ...


from quadruped_env.page.document import check_exportable
